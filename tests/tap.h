/* SPDX-License-Identifier: Apache-2.0 */
/* Prints test results in TAP: tap_ok() for each check, and return tap_done() from main(). */
#ifndef PSC_TESTS_TAP_H
#define PSC_TESTS_TAP_H

#include <stdarg.h>
#include <stdio.h>

#if defined(__GNUC__)
#define TAP_FORMAT(n) __attribute__((unused, format(printf, n, n + 1)))
#else
#define TAP_FORMAT(n)
#endif

static int tap_count, tap_failures;

/* One check, named by a printf format; returns ok, so that a failure can explain itself. */
TAP_FORMAT(2) static int tap_ok(int ok, const char *name, ...)
{
    va_list arguments;
    tap_failures += !ok;
    printf("%sok %d - ", ok ? "" : "not ", ++tap_count);
    va_start(arguments, name);
    vprintf(name, arguments);
    va_end(arguments);
    putchar('\n');
    return ok;
}

/* A check that cannot be made here, and why. */
TAP_FORMAT(1) static void tap_skip(const char *reason, ...)
{
    va_list arguments;
    printf("ok %d # SKIP ", ++tap_count);
    va_start(arguments, reason);
    vprintf(reason, arguments);
    va_end(arguments);
    putchar('\n');
}

/* A line of explanation. */
TAP_FORMAT(1) static void tap_note(const char *text, ...)
{
    va_list arguments;
    printf("# ");
    va_start(arguments, text);
    vprintf(text, arguments);
    va_end(arguments);
    putchar('\n');
}

/* The plan; a program that ends before it fails. */
static inline int tap_done(void)
{
    printf("1..%d\n", tap_count);
    return tap_failures != 0;
}

#endif
