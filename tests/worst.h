/* SPDX-License-Identifier: Apache-2.0 */
/* Keeps the largest error of a sweep with the case that gave it, in full. */
#ifndef PSC_TESTS_WORST_H
#define PSC_TESTS_WORST_H

#include "tap.h"

struct worst {
    double value;
    long count;
    char where[2200];
};

/* Adds an error; one that is not a number is the worst of all. The format describes the case. */
TAP_FORMAT(3) static void worst_add(struct worst *w, double error, const char *format, ...)
{
    va_list arguments;

    if (!(error == error))
        error = 1.0 / 0.0;
    w->count++;
    if (w->count > 1 && error <= w->value)
        return;
    w->value = error;
    va_start(arguments, format);
    vsnprintf(w->where, sizeof w->where, format, arguments);
    va_end(arguments);
}

/* One check: that something was compared, and no error was over the bound. */
TAP_FORMAT(3) static int worst_report(const struct worst *w, double bound, const char *format, ...)
{
    char name[200];
    va_list arguments;
    int ok = w->count > 0 && w->value <= bound;

    va_start(arguments, format);
    vsnprintf(name, sizeof name, format, arguments);
    va_end(arguments);
    tap_ok(ok, "%s: %.3g of at most %.3g in %ld", name, w->value, bound, w->count);
    tap_note("    at %s", w->count > 0 ? w->where : "no case at all");
    return ok;
}

#endif
