/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Shapes as the tests see them: what holds for every light is tested on every row of the table,
 * with all techniques that it lists.
 *
 * To add a shape: write its row, of type struct shape, in a file shapes_FAMILY.c beside those that
 * are there, add its name to TEST_SHAPES below and the file to shapes_sources in meson.build; then
 * record the digests (check_digest --record). The tests themselves need no change.
 */
#ifndef PSC_TESTS_SHAPES_H
#define PSC_TESTS_SHAPES_H

#include "calls.h"
#include "random.h"

#define TEST_SHAPES(X)                                         \
    X(sphere) X(cap) X(disk) X(ellipse) X(ellipsoid)           \
    X(triangle) X(rectangle)                                   \
    X(polygon3) X(polygon4) X(polygon5) X(polygon8) X(polygon16)

enum { GEOMETRY_MAX = 48, PARTS_MAX = 16 };

struct light;

typedef void shape_maker(uint64_t *state, const struct test_technique *what, int hard,
                         double *geometry);

struct shape {
    const char *name;
    psc_shape shape;
    /* A letter for each part of the geometry, in the order of the build call: p point, d direction
       of any length but 0, e edge or semi-axis, r radius, a angle. Lights without a point are
       distant. */
    const char *parts;
    int flat;                                /* a surface with two sides, not a closed one */
    int bound;                               /* parts must fit each other: no numbers will do */
    const struct test_technique *techniques; /* all that are offered; the last has no name */
    /* How often a sample may jump, of paths that a receiver takes: 0 for lights that say where the
       maps begin. The axes of a cone do not: on a way around a receiver that sees it circular
       they come back reversed, so that no rule for them is without a jump. */
    double jumps;
    /* The same by projected solid angle, of lights whose azimuths begin anew as the receiver's
       normal crosses a side. No rule is without: outside, azimuths begin along that side, and for
       a normal that goes around within the light that direction turns once, which one that it has
       everywhere inside cannot. */
    double azimuth_jumps;

    /* The public calls. The geometry is the numbers of all parts, `in` has an input for each part;
       where they are vertices in one array, in[0] is that array. SHAPE_WAVES writes the waves. */
    int joined; /* the parts are one array */
    psc_result (*build)(psc_sampler *sampler, const psc_technique *technique,
                        const psc_receiver *receiver, const double *geometry);
    psc_result (*wave_f32)(const psc_technique *technique, size_t count,
                           const psc_receivers_f32 *receivers, const psc_input_f32 *const *in,
                           const psc_input_f32 *uv, const psc_samples_f32 *out);
    psc_result (*wave_f64)(const psc_technique *technique, size_t count,
                           const psc_receivers_f64 *receivers, const psc_input_f64 *const *in,
                           const psc_input_f64 *uv, const psc_samples_f64 *out);
    psc_result (*solid_angle)(const double position[3], const double *geometry, double *value);
    psc_result (*form_factor)(const psc_receiver *receiver, const double *geometry,
                              double *value); /* NULL if it is not offered */

    /* A light about the origin, which is in the middle of it, and within a distance of 1. Flat
       ones lie in the plane z = 0 with normal (0,0,1); the middle of distant ones is (0,0,1).
       `hard` asks for extreme forms too: needles, aspects down to 1e-8. */
    shape_maker *make;

    /* How far along a ray the light is, in lengths of the direction; negative if it is missed.
       From inside, where the ray leaves. Plain geometry that shares nothing with the library. */
    double (*hit)(const double *geometry, const double from[3], const double direction[3]);

    /* How far a point is off the surface, and the outward unit normal next to it. */
    double (*surface)(const double *geometry, const double point[3], double normal[3]);

    /* The point that texture coordinates stand for; NULL if the shape has none. */
    void (*texture)(const double *geometry, const double st[2], double point[3]);

    /* A light, receiver and normal made of integers, with the situations that are this shape's
       alone; NULL for what place_exactly() does with `make`. */
    void (*exact)(uint64_t *state, struct light *light);
};

#define DECLARE(name) extern const struct shape shape_##name;
TEST_SHAPES(DECLARE)
#undef DECLARE

/* Every shape; the last is NULL. */
extern const struct shape *const shapes[];

/* for (FOR_TECHNIQUES(shape, what)) runs through the techniques of a shape. */
#define FOR_TECHNIQUES(shape, what) what = (shape)->techniques; what->name; what++

/* Defines NAME_wave_f32 and _f64 for a row: SHAPE_WAVES(sphere, sphere, in[0], in[1]), the second
   name being the public functions', with their arguments for the light. */
#define SHAPE_WAVE(name, function, bits, ...)                                                   \
    static psc_result name##_wave_##bits(                                                       \
        const psc_technique *technique, size_t count, const psc_receivers_##bits *receivers,    \
        const psc_input_##bits *const *in, const psc_input_##bits *uv,                          \
        const psc_samples_##bits *out)                                                          \
    {                                                                                           \
        return psc_##function##_sample_n_##bits(technique, count, receivers, __VA_ARGS__, uv,   \
                                                out);                                           \
    }
#define SHAPE_WAVES(name, function, ...)         \
    SHAPE_WAVE(name, function, f32, __VA_ARGS__) \
    SHAPE_WAVE(name, function, f64, __VA_ARGS__)

static inline int part_size(char part)
{
    return part == 'r' || part == 'a' ? 1 : 3;
}

static inline int part_count(const struct shape *shape)
{
    return (int)strlen(shape->parts);
}

/* Numbers of the geometry. */
static inline int geometry_size(const struct shape *shape)
{
    int i, n = 0;

    for (i = 0; shape->parts[i]; i++)
        n += part_size(shape->parts[i]);
    return n;
}

static inline int is_distant(const struct shape *shape)
{
    return strchr(shape->parts, 'p') == NULL;
}

/* ---- Lights seen by receivers ---- */

struct light {
    const struct shape *shape;
    const struct test_technique *what;
    int has_normal;
    uint32_t flags;           /* of the receiver */
    uint32_t technique_flags;
    double position[3], normal[3], geometry[GEOMETRY_MAX];
    double middle[3], reach;  /* the light is within reach of its middle; distant: direction, 0 */
};

/* What becomes of a cosine. */
enum { FACING_NONE, FACING_ONE, FACING_BOTH, FACINGS };

/* Where the receiver is. */
enum {
    PLACE_ORDINARY, /* a hundredth to ten times the light's size away */
    PLACE_FAR,      /* 10 to 1000 times */
    PLACE_TINY,     /* up to 1e8 times */
    PLACE_CLOSE,    /* down to 1e-9 of it from the surface */
    PLACE_GRAZING,  /* flat: down to 1e-9 over its plane, beside it; others: on the surface */
    PLACE_INSIDE,   /* flat: in its plane, to rounding, beside or on it */
    PLACES
};

/* How high the middle of the light is over the receiver's horizon. */
enum {
    HORIZON_ANY,
    HORIZON_ABOVE, /* all of it */
    HORIZON_TOUCH, /* just not touched, or just cut */
    HORIZON_CUT,   /* partly below, the middle above, below or on it */
    HORIZON_LOW,   /* hardly above */
    HORIZON_BELOW,
    HORIZONS
};

/* From where a light is made to where it is: rotated, scaled, shifted. */
struct motion {
    double x[3], y[3], z[3], scale, shift[3];
};

/* Moves what `make` made; directions get the length. */
void move_geometry(const struct motion *motion, double length, struct light *light);

/* Whether the technique can be built for this facing. */
int is_offered(const struct test_technique *what, int facing);

void place_light(uint64_t *state, const struct shape *shape, const struct test_technique *what,
                 int place, int horizon, int facing, struct light *light);

/* Any facing; places and forms are ordinary here: what is tested must hold to rounding. */
void random_light(uint64_t *state, const struct shape *shape, const struct test_technique *what,
                  struct light *light);

/* Any light that there is, of any form, wherever the receiver. */
void random_hard_light(uint64_t *state, const struct shape *shape,
                       const struct test_technique *what, struct light *light);

/* A light that is the same on every machine: made of integers, often exactly on a boundary. */
void exact_light(uint64_t *state, const struct shape *shape, const struct test_technique *what,
                 struct light *light);

/* Takes its size away. */
void shrink_to_nothing(struct light *light);

psc_technique light_technique(const struct light *light);
psc_receiver light_receiver(const struct light *light);
psc_result build_light(psc_sampler *sampler, const struct light *light);

/* All of it as hexadecimal floats, in memory that the next call overwrites. */
const char *describe_light(const struct light *light);

#endif
