/* SPDX-License-Identifier: Apache-2.0 */
#include "bench.h"

#include <string.h>
#include <sys/utsname.h>

/* What /proc/cpuinfo says after a key, or 0. */
static int cpuinfo(const char *key, char *to, size_t size)
{
    FILE *f = fopen("/proc/cpuinfo", "r");
    char line[512];
    int found = 0;

    while (f && !found && fgets(line, sizeof line, f)) {
        const char *colon = strchr(line, ':');

        if (colon && !strncmp(line, key, strlen(key))) {
            snprintf(to, size, "%s", colon + 1 + (colon[1] == ' '));
            to[strcspn(to, "\n")] = '\0';
            found = 1;
        }
    }
    if (f)
        fclose(f);
    return found;
}

void describe_machine(struct machine *machine)
{
    struct utsname name;

    if (!cpuinfo("model name", machine->cpu, sizeof machine->cpu) &&
        !cpuinfo("CPU part", machine->cpu, sizeof machine->cpu))
        snprintf(machine->cpu, sizeof machine->cpu, "%s",
                 uname(&name) == 0 ? name.machine : "unknown");
#if defined(__clang__)
    machine->compiler = __VERSION__;
#else
    machine->compiler = "gcc " __VERSION__;
#endif
    machine->flags = BENCH_FLAGS;
}
