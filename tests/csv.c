/* SPDX-License-Identifier: Apache-2.0 */
#include "csv.h"

#include <ctype.h>
#include <string.h>

/* A whole line, without its end. */
static int read_line(struct csv *csv)
{
    size_t length;

    if (!fgets(csv->text, sizeof csv->text, csv->file))
        return ferror(csv->file) ? -1 : 0;
    csv->line++;
    length = strlen(csv->text);
    if (length + 1 == sizeof csv->text)
        return -1;
    while (length > 0 && (csv->text[length - 1] == '\n' || csv->text[length - 1] == '\r'))
        csv->text[--length] = '\0';
    return 1;
}

const char *csv_open(struct csv *csv, const char *path)
{
    csv->path = path;
    csv->line = 0;
    csv->file = fopen(path, "r");
    if (!csv->file)
        return "cannot be read";
    if (read_line(csv) == 1)
        return NULL;
    csv_close(csv);
    return "does not begin with a line of column names";
}

int csv_read(struct csv *csv, int count)
{
    char *at = csv->text;
    int i, result = read_line(csv);

    if (result != 1)
        return result;
    for (i = 0; i < count; i++) {
        char *end;

        if (i == 0 && isalpha((unsigned char)*at)) {
            at += strcspn(at, ",");
            csv->number[0] = 0.0;
            csv->exact[0] = 0;
            if (*at++ != ',')
                return -1;
            continue;
        }
        csv->number[i] = strtod(at, &end);
        csv->exact[i] = quad_parse(at, &end);
        if (end == at || !isfinite(csv->number[i]) || *end != (i + 1 < count ? ',' : '\0'))
            return -1;
        at = end + 1;
    }
    return 1;
}

void csv_close(struct csv *csv)
{
    fclose(csv->file);
}
