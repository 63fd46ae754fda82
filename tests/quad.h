/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Arithmetic with at least 113 bits for reference values: long double where it is that wide,
 * else the compiler's __float128 with libquadmath (declared here: its header belongs to gcc).
 */
#ifndef PSC_TESTS_QUAD_H
#define PSC_TESTS_QUAD_H

#include <float.h>
#include <math.h>
#include <stdlib.h>

#if LDBL_MANT_DIG >= 113

typedef long double quad;
#define QUAD_FUNCTION(name) name##l
#define quad_parse strtold

#else

__extension__ typedef __float128 quad;
#define QUAD_FUNCTION(name) name##q
#define quad_parse strtoflt128
quad strtoflt128(const char *, char **);
quad sqrtq(quad), fabsq(quad), sinq(quad), cosq(quad), asinq(quad), acosq(quad);
quad atan2q(quad, quad), fmaq(quad, quad, quad);

#endif

#define quad_sqrt QUAD_FUNCTION(sqrt)
#define quad_abs QUAD_FUNCTION(fabs)
#define quad_sin QUAD_FUNCTION(sin)
#define quad_cos QUAD_FUNCTION(cos)
#define quad_asin QUAD_FUNCTION(asin)
#define quad_acos QUAD_FUNCTION(acos)
#define quad_atan2 QUAD_FUNCTION(atan2)

static inline quad quad_square(quad x)
{
    return x * x;
}

/* A quotient of integers keeps constants out of the double range of literals. */
static inline quad quad_pi(void)
{
    return 4 * quad_atan2(1, 1);
}

#endif
