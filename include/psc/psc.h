/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file psc.h
 * Exact, area-preserving sampling of light sources seen from a point.
 *
 * A renderer asks, at every shading point: give me a random direction towards this light, and
 * its density. libpsc answers with maps from the unit square: stratified points in, stratified
 * directions out, with the density exactly as stated.
 *
 *     psc_sampler_storage storage;
 *     psc_sampler *sampler;
 *     psc_sampler_init(&storage, sizeof storage, &sampler);             once per thread
 *
 *     psc_build_sphere(sampler, &technique, &receiver, center, radius); once per shading point
 *     psc_sample_f64(sampler, u, v, &sample);                           as often as wanted
 *     L += radiance * bsdf * sample.weight;                             weight = cosine / pdf
 *
 * Conventions that hold for every function:
 *
 * - Vectors are in the caller's right-handed world space, lengths in any one unit, angles in
 *   radians, solid angles in steradians. A pdf is always with respect to solid angle.
 * - The unit square includes its ends: u and v may be 0 or 1. A coordinate outside [0,1] or NaN
 *   gives an unspecified direction, never a crash.
 * - Functions return a psc_result. Zero is success, a positive value is a status (nothing went
 *   wrong, but see there), a negative value is an error. On an error no output is written,
 *   except that a pointer to a handle receives NULL and a sampler being built becomes empty.
 * - Nothing is printed, no memory is allocated outside psc_sampler_create(), the floating-point
 *   environment is neither read nor changed, and there is no global state. Results hold for
 *   round-to-nearest with subnormals on.
 * - Building, and anything else that takes a non-const sampler, needs exclusive use of it. A
 *   built sampler is immutable: any number of threads may sample it at the same time.
 * - Geometry is given in double; a float converts exactly. The suffixes _f32 and _f64 name the
 *   precision of what is sampled. Multiplying every length by a power of two changes nothing
 *   but the lengths that are returned.
 *
 * Sources, cited below by their short names:
 *   [UG18]  C. Ureña, I. Georgiev: Stratified Sampling of Projected Spherical Caps. EGSR 2018.
 *   [GUK17] I. Guillén, C. Ureña, A. King, M. Fajardo, I. Georgiev, J. López-Moreno, A. Jarabo:
 *           Area-Preserving Parameterizations for Spherical Ellipses. EGSR 2017.
 *   [Wan92] C. Wang: Physically correct direct lighting for distribution ray tracing.
 *           Graphics Gems III, 1992.
 *   [SC97]  P. Shirley, K. Chiu: A low distortion map between disk and square. JGT 2(3), 1997.
 *   [UFK13] C. Ureña, M. Fajardo, A. King: An area-preserving parametrization for spherical
 *           rectangles. EGSR 2013.
 *   [Arv95] J. Arvo: Stratified sampling of spherical triangles. SIGGRAPH 1995.
 *   [Arv01] J. Arvo: Stratified sampling of 2-manifolds. SIGGRAPH course notes, 2001.
 *   [Pet21] C. Peters: BRDF importance sampling for polygonal lights. ACM Transactions on
 *           Graphics 40(4), 2021.
 *   [DBC17] T. Duff, J. Burgess, P. Christensen, C. Hery, A. Kensler, M. Liani, R. Villemin:
 *           Building an orthonormal basis, revisited. JCGT 6(1), 2017.
 *   [OS83]  A. Van Oosterom, J. Strackee: The solid angle of a plane triangle. IEEE Transactions
 *           on Biomedical Engineering 30(2), 1983.
 */
#ifndef PSC_PSC_H
#define PSC_PSC_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(_WIN32) && defined(PSC_BUILDING)
#define PSC_API __declspec(dllexport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define PSC_API __attribute__((visibility("default")))
#else
#define PSC_API
#endif

/* ---- Version --------------------------------------------------------------------------- */

/** Version of this header. */
#define PSC_VERSION_MAJOR 0
#define PSC_VERSION_MINOR 1
#define PSC_VERSION_PATCH 0

/** The header's version as one number: major << 22 | minor << 12 | patch. */
#define PSC_VERSION 4096

/** Version of the library that is running, packed like PSC_VERSION. @since 0.1 */
PSC_API uint32_t psc_version(void);

/* ---- Results --------------------------------------------------------------------------- */

/** Outcome of a call: 0 success, positive a status, negative an error. */
typedef int32_t psc_result;

enum {
    PSC_SUCCESS = 0,
    /** Nothing of the light can be seen from the receiver: totals and pdfs are 0, there is
        nothing to sample, outputs of sampling calls are left as they were. */
    PSC_EMPTY = 1,
    /** The sample was written and its pdf holds, but it carries no light to the receiver: it
        lies below or on the receiver's horizon, or on the far side of the light. Its weight is
        0. With PSC_MAP_TABULATED, and a pdf of 0 too, the point of the square is one without a
        direction. */
    PSC_CULLED = 2,
    /** The direction is not one that the sampler can give; nothing was written. */
    PSC_OUTSIDE = 3,

    PSC_ERROR_NULL_POINTER = -1,
    PSC_ERROR_STRUCT_SIZE = -2,
    PSC_ERROR_UNKNOWN_FIELD = -3,
    PSC_ERROR_STORAGE = -4,
    PSC_ERROR_OUT_OF_MEMORY = -5,
    PSC_ERROR_NOT_FINITE = -6,
    PSC_ERROR_ZERO_VECTOR = -7,
    PSC_ERROR_NEGATIVE_SIZE = -8,
    PSC_ERROR_HALF_ANGLE = -9,
    PSC_ERROR_UNKNOWN_MEASURE = -10,
    PSC_ERROR_UNKNOWN_MAP = -11,
    PSC_ERROR_UNKNOWN_FLAG = -12,
    PSC_ERROR_UNSUPPORTED_TECHNIQUE = -13,
    PSC_ERROR_NEEDS_NORMAL = -14,
    PSC_ERROR_UNKNOWN_VERSION = -15,
    PSC_ERROR_VERTEX_COUNT = -16,
    PSC_ERROR_NOT_PLANAR = -17,
    PSC_ERROR_NOT_CONVEX = -18,
    PSC_ERROR_NOT_RECTANGLE = -19,
    PSC_ERROR_NEEDS_TABLE = -20,
    PSC_ERROR_RESOLUTION = -21
};

/** What a result means, in words; never NULL, also for numbers that mean nothing. @since 0.1 */
PSC_API const char *psc_result_string(psc_result result);

/* ---- What is asked for ------------------------------------------------------------------ */

/** The measure in which samples are uniform. */
typedef uint32_t psc_measure;

enum {
    /** Uniform in solid angle over the whole light, horizon not considered; samples below the
        horizon of a receiver with a normal come with PSC_CULLED. */
    PSC_MEASURE_SOLID_ANGLE = 0,
    /** Uniform in projected solid angle over the part of the light above the receiver's
        horizon: pdf = cosine / projected solid angle, so that one sample gives unoccluded
        diffuse light exactly. Needs a receiver with a normal. [UG18] */
    PSC_MEASURE_PROJECTED_SOLID_ANGLE = 1,
    /** Uniform in area over the whole surface of the light, one face of a flat one; samples on
        the far side come with PSC_CULLED. */
    PSC_MEASURE_AREA = 2,
    /** Uniform in area over the part of the surface that faces the receiver. The density of
        directions is infinite at the limb, where the weight is 0. From a point on the surface
        both area measures are PSC_EMPTY. */
    PSC_MEASURE_VISIBLE_AREA = 3
};

/** What PSC_MAP_TABULATED looks up, see psc_table_init(). Opaque. */
typedef struct psc_table psc_table;

/** How the unit square is laid over the light. */
typedef uint32_t psc_map;

enum {
    /** Polar. Spheres and caps: u moves outwards from the centre (from the inner edge of a
        lune), v around it; for projected solid angle section 4.2 and listing 1 of [UG18]. Disks
        and ellipsoids: u around the centre, v from the outline (0) to it (1), section 3.2 of
        [GUK17]. Polygons: around a vertex, see psc_build_triangle(). */
    PSC_MAP_RADIAL = 0,
    /** Parallel chords. Spheres and caps: v selects one, u moves along it, section 4.1 of [UG18].
        Disks and ellipsoids: u selects one, v moves along it, section 3.1 of [GUK17]; for
        projected solid angle see psc_build_disk().
        Rectangles: along the edges, see psc_build_rectangle(). */
    PSC_MAP_PARALLEL = 1,
    /** Low distortion: the square is first laid over a disk by [SC97], so that neighbouring
        points stay neighbours all round. */
    PSC_MAP_CONCENTRIC = 2,
    /** Disks and ellipsoids: the radial map with a guess in place of its solution, a build without
        any series, and its exact density, which is not constant but nearly so. See
        psc_build_disk() for how nearly. */
    PSC_MAP_QUASI_UNIFORM = 3,
    /** Disks and ellipsoids: the radial map by a table, section 4.1 of [GUK17], for comparison with
        what was done with it. See psc_table_init(). */
    PSC_MAP_TABULATED = 4
};

/**
 * How to sample. All zero but for struct_size is the default: solid angle, radial.
 *
 *                               sphere, cap                            sphere only
 *                      solid angle   projected solid angle      area   visible area
 *     radial               x                  x                  x          x
 *     parallel                                x
 *     concentric           x                  x                  x          x
 *
 *                         disk, ellipse, ellipsoid               disk, ellipse
 *                      solid angle   projected solid angle           area
 *     radial               x                                           x
 *     parallel             x                  x                        x
 *     concentric           x                                           x
 *     quasi-uniform        x
 *     tabulated            x
 *
 *                     triangle, rectangle, polygon               rectangle only
 *                 solid angle  projected s. angle  area        solid angle    area
 *     radial           x               x            x
 *     parallel                                                      x           x
 *
 * A combination that a shape does not offer is PSC_ERROR_UNSUPPORTED_TECHNIQUE when it is
 * built, never a silent substitute.
 */
typedef struct psc_technique {
    uint32_t struct_size; /**< sizeof(psc_technique) */
    psc_measure measure;
    psc_map map;
    uint32_t flags; /**< 0 or PSC_TECHNIQUE_ONE_SIDED */
    /** For PSC_MAP_TABULATED, and must outlive the samplers that are built with it; not read
        otherwise. */
    const psc_table *table;
} psc_technique;

enum {
    /** The light leaves its surface on the side of its outward normal only: receivers behind a
        flat light, or inside a closed one, see nothing (PSC_EMPTY). Otherwise both sides shine.
        Distant lights always face the receiver. */
    PSC_TECHNIQUE_ONE_SIDED = 1
};

enum {
    /** Light counts on both sides of the receiver's tangent plane: the cosine is |n . w|. */
    PSC_RECEIVER_TWO_SIDED = 1
};

/** The point that is lit. */
typedef struct psc_receiver {
    uint32_t struct_size;   /**< sizeof(psc_receiver) */
    uint32_t flags;         /**< 0 or PSC_RECEIVER_TWO_SIDED */
    const double *position; /**< 3 finite numbers */
    const double *normal;   /**< any length but 0; NULL for a point in a volume */
} psc_receiver;

/* ---- The sampler ------------------------------------------------------------------------ */

/** A light seen from a receiver, ready to be sampled. Opaque. */
typedef struct psc_sampler psc_sampler;

/** Room for a sampler on the stack or inside another object. */
typedef union psc_sampler_storage {
    double align_double;
    void *align_pointer;
    unsigned char bytes[16384];
} psc_sampler_storage;

/** Where psc_sampler_create() gets its memory. */
typedef struct psc_allocator {
    uint32_t struct_size; /**< sizeof(psc_allocator) */
    uint32_t reserved;    /**< 0 */
    void *user;           /**< passed to both functions */
    /** Returns size bytes aligned to align (at most malloc's alignment), or NULL. */
    void *(*allocate)(void *user, size_t size, size_t align);
    void (*release)(void *user, void *memory);
} psc_allocator;

/** Bytes that psc_sampler_init() needs; at most sizeof(psc_sampler_storage). @since 0.1 */
PSC_API size_t psc_sampler_size(void);

/** Alignment that psc_sampler_init() needs; at most that of psc_sampler_storage. @since 0.1 */
PSC_API size_t psc_sampler_align(void);

/**
 * Makes an empty sampler in the caller's memory. It owns nothing, needs no destroying, and may
 * be copied or moved with memcpy.
 * @param memory  psc_sampler_size() bytes or more, aligned to psc_sampler_align()
 * @param size    bytes at memory
 * @param out     receives the sampler, or NULL on failure
 * @return PSC_ERROR_NULL_POINTER, or PSC_ERROR_STORAGE when memory is too small or misaligned
 * @since 0.1
 */
PSC_API psc_result psc_sampler_init(void *memory, size_t size, psc_sampler **out);

/**
 * Makes an empty sampler in allocated memory: one call of the allocator, here and nowhere else.
 * @param allocator  NULL for malloc and free; copied, so it need not outlive the call
 * @param out        receives the sampler, or NULL on failure
 * @return PSC_ERROR_NULL_POINTER, PSC_ERROR_STRUCT_SIZE, PSC_ERROR_UNKNOWN_FIELD,
 *         PSC_ERROR_OUT_OF_MEMORY
 * @since 0.1
 */
PSC_API psc_result psc_sampler_create(const psc_allocator *allocator, psc_sampler **out);

/** Releases a sampler from psc_sampler_create(); NULL and initialised ones are left alone.
    @since 0.1 */
PSC_API void psc_sampler_destroy(psc_sampler *sampler);

/* ---- Building: one call per shape, once per shading point --------------------------------- */

/**
 * Builds the sampler of a spherical light.
 *
 * From a point inside, the light is all around: solid angle samples the whole sphere of
 * directions, projected solid angle the cosine-weighted hemisphere (both, when the receiver is
 * two-sided). From a point on the surface it fills a half space.
 * @param sampler    is empty afterwards unless the result is PSC_SUCCESS
 * @param technique  what to sample, see psc_technique
 * @param receiver   from where; read during the call only
 * @param center     3 finite numbers
 * @param radius     finite; 0 is PSC_EMPTY
 * @return PSC_SUCCESS; PSC_EMPTY when nothing is visible (below the horizon, radius 0);
 *         PSC_ERROR_NULL_POINTER, _STRUCT_SIZE, _UNKNOWN_FIELD, _UNKNOWN_MEASURE, _UNKNOWN_MAP,
 *         _UNKNOWN_FLAG, _UNSUPPORTED_TECHNIQUE, _NEEDS_NORMAL, _NOT_FINITE, _ZERO_VECTOR (the
 *         normal) or _NEGATIVE_SIZE
 * @since 0.1
 */
PSC_API psc_result psc_build_sphere(psc_sampler *sampler, const psc_technique *technique,
                                    const psc_receiver *receiver, const double center[3],
                                    double radius);

/**
 * Builds the sampler of a distant light that fills a spherical cap: the sun, or any light whose
 * direction and size do not depend on where the receiver is. Samples come with an infinite
 * distance, the direction as their point, and a normal that faces the receiver.
 * @param axis        direction to the middle of the light; any length but 0
 * @param half_angle  angle between axis and edge, 0 (PSC_EMPTY) to pi; at most pi/2 for
 *                    projected solid angle. Up to pi or pi/2 as rounded to double.
 * @return as psc_build_sphere(), with PSC_ERROR_HALF_ANGLE for one that is too large
 * @since 0.1
 */
PSC_API psc_result psc_build_cap(psc_sampler *sampler, const psc_technique *technique,
                                 const psc_receiver *receiver, const double axis[3],
                                 double half_angle);

/**
 * Builds the sampler of a circular disk. Both of its faces shine unless the technique is one-sided.
 *
 * Solid angle follows [GUK17], exactly and without tables: u = e1, v = e2 there, in the frame of
 * the spherical ellipse (x along its long semi-arc). The radial map has e2 = 0 on the outline as in
 * equation 22, the concentric one 1 - e2 = r^2. Area has the same three maps on the disk itself,
 * along the axes of psc_light_sample_f64.surface: s is along (-nz, 0, nx) if |nx| > |ny|, else
 * along (0, nz, -ny), and t along n x s.
 *
 * The quasi-uniform map is the radial one with the angle of e1 taken from tan(phi') =
 * mu tan(2 pi e1) in the eccentric anomaly phi', mu^2 = (1 + cos alpha) / (1 + cos beta), alpha and
 * beta the semi-arcs. Its pdf is exact and not constant. Times the solid angle it is, for any beta,
 * within 1 +- 7.3e-10 at alpha = 1 degree, 4.6e-7 at 5, 3.8e-5 at 15, 6.3e-4 at 30, 0.0035 at 45,
 * 0.013 at 60, 0.036 at 75, and between 0.90 and 1.09 at the worst. Where the middle is reached
 * (v = 1), where directions of every angle meet, the pdf of a direction is that at u = 0.
 *
 * Projected solid angle takes what is above the receiver's horizon in fibres: where planes through
 * the horizontal line across the axis z of the cone of directions cut it. u runs from the highest
 * fibre (0) to the lowest or the horizon (1), v along a fibre, towards z x n. For a receiver that
 * is lit on both sides u goes on beyond the horizon to the fibre farthest below, each side having
 * its share of the total. Totals are within 3e-15 of themselves however little of the light is
 * above the horizon, u and v within 1e-14 of exact; needles of nearly half a turn (to 1e-4), seen
 * along their length, may lose digits, to 3e-11. Lights of up to 0.9 radians that are not just
 * touched by the horizon are fastest by far.
 * @param normal  any length but 0; the samples' normal
 * @param radius  finite; 0 is PSC_EMPTY
 * @return as psc_build_sphere(), with _ZERO_VECTOR also for the disk's normal; PSC_EMPTY also for a
 *         receiver in the plane of the disk, and behind a one-sided one
 * @since 0.1
 */
PSC_API psc_result psc_build_disk(psc_sampler *sampler, const psc_technique *technique,
                                  const psc_receiver *receiver, const double center[3],
                                  const double normal[3], double radius);

/**
 * Builds the sampler of an elliptical disk: the points center + s axis_u + t axis_v with
 * s^2 + t^2 <= 1. Its normal is along axis_u x axis_v.
 * @param axis_u,axis_v  conjugate semi-axes, finite; they need not be perpendicular. In one line:
 *                       PSC_EMPTY
 * @return as psc_build_disk(), but never _NEGATIVE_SIZE
 * @since 0.1
 */
PSC_API psc_result psc_build_ellipse(psc_sampler *sampler, const psc_technique *technique,
                                     const psc_receiver *receiver, const double center[3],
                                     const double axis_u[3], const double axis_v[3]);

/**
 * Builds the sampler of an ellipsoid: the points center + r axis_u + s axis_v + t axis_w with
 * r^2 + s^2 + t^2 <= 1. Its outline is that of an elliptical disk, which is what is sampled.
 *
 * From inside, the light is all around and solid angle samples the whole sphere of directions, in
 * a frame along the coordinate axes. From a point on the surface it fills a half space.
 * @param axis_u,axis_v,axis_w  conjugate semi-axes, finite; they need not be perpendicular. In one
 *                              plane: PSC_EMPTY
 * @return as psc_build_ellipse(), and PSC_EMPTY inside a one-sided ellipsoid
 * @since 0.1
 */
PSC_API psc_result psc_build_ellipsoid(psc_sampler *sampler, const psc_technique *technique,
                                       const psc_receiver *receiver, const double center[3],
                                       const double axis_u[3], const double axis_v[3],
                                       const double axis_w[3]);

/**
 * Builds the sampler of a triangular light.
 *
 * Solid angle: Arvo's map [Arv95] with his names, A = v0, B = v1, C = v2. u is the fraction of
 * the solid angle between the side from v1 to v0 and the arc on which the sample lies, which
 * runs from v1 to a point of the side from v0 to v2; v is the fraction of the cap around v1 that
 * is nearer to it. So v = 0 is v1, v = 1 the side from v0 to v2, u = 0 the side to v0, u = 1 that
 * to v2. Area: the same with areas, v1 + sqrt(v) ((1 - u) (v0 - v1) + u (v2 - v1)).
 *
 * Projected solid angle [Arv01], [Pet21], of the part above the receiver's horizon: u is its
 * fraction at smaller azimuths, counter-clockwise around the receiver's normal, from the azimuth
 * at which that part begins, or from its first vertex when the normal points into it; v is the
 * fraction, at the azimuth of the sample, that is nearer to the normal, in which the squared sine
 * of the angle to it is linear. For a two-sided receiver u below the share of the part above goes
 * to that; the rest, backwards, to the part below, which is sampled as its mirror image is. The
 * map jumps there, and as a receiver turns where its normal crosses a side.
 *
 * Both sides shine unless the technique says PSC_TECHNIQUE_ONE_SIDED; the front is the one from
 * which v0, v1, v2 run counter-clockwise. Samples come with the normal of the front, the unit
 * vector along (v1 - v0) x (v2 - v0), and with surface the barycentric coordinates of v1 and v2.
 * @param v0,v1,v2  vertices, finite; a triangle without area, or seen edge-on, is PSC_EMPTY
 * @return as psc_build_sphere() but for the radius
 * @since 0.1
 */
PSC_API psc_result psc_build_triangle(psc_sampler *sampler, const psc_technique *technique,
                                      const psc_receiver *receiver, const double v0[3],
                                      const double v1[3], const double v2[3]);

/**
 * Builds the sampler of a rectangular light.
 *
 * Parallel maps keep its grid: u moves along edge_u, v along edge_v. By solid angle [UFK13] u is
 * the fraction of the solid angle at smaller fractions of edge_u, and v that within the strip at
 * that fraction. Radial maps are those of the polygon corner, corner + edge_u, corner + edge_u +
 * edge_v, corner + edge_v, see psc_build_polygon().
 *
 * The front is the side that edge_u x edge_v points to, which is the direction of the samples'
 * normals; surface has the fractions of edge_u and edge_v.
 * @param corner         finite
 * @param edge_u,edge_v  from there, finite; without length: PSC_EMPTY. Perpendicular to within
 *                       1e-6 as a cosine, else PSC_ERROR_NOT_RECTANGLE; what edge_v has along
 *                       edge_u is then left out.
 * @return as psc_build_triangle(), or PSC_ERROR_NOT_RECTANGLE
 * @since 0.1
 */
PSC_API psc_result psc_build_rectangle(psc_sampler *sampler, const psc_technique *technique,
                                       const psc_receiver *receiver, const double corner[3],
                                       const double edge_u[3], const double edge_v[3]);

/**
 * Builds the sampler of a convex polygon: a fan of triangles about v0, each sampled like
 * psc_build_triangle() with A = v(i), B = v0, C = v(i + 1). u runs through the fan from v1 to the
 * last vertex, and v from v0 outwards, without seams between the triangles. By projected solid
 * angle: as for triangles.
 *
 * The front is the side from which the vertices run counter-clockwise. Surface has the numbers s
 * and t with point = v0 + s (v1 - v0) + t (v(last) - v0); 0 if these two edges are in line.
 * @param count     3 to 16 vertices
 * @param vertices  three finite numbers each, in order around the polygon, nowhere turning back by
 *                  more than 1e-6 as a sine, and in one plane to within 1e-6 of the polygon's extent
 *                  and of its largest coordinate, taken together: 16 roundings to float of that, so
 *                  that those that are kept in float may be anywhere. Where they are not in one
 *                  plane, points by solid angle and by area are on the triangles of the fan, by
 *                  projected solid angle on segments from edge to edge; the normal is the mean of
 *                  those of the triangles, by area.
 *                  Several may be in line or the same. Without area: PSC_EMPTY.
 * @param stride    bytes from one vertex to the next; 3 * sizeof(double) for packed ones
 * @return as psc_build_triangle(), or PSC_ERROR_VERTEX_COUNT, PSC_ERROR_NOT_PLANAR,
 *         PSC_ERROR_NOT_CONVEX
 * @since 0.1
 */
PSC_API psc_result psc_build_polygon(psc_sampler *sampler, const psc_technique *technique,
                                     const psc_receiver *receiver, size_t count,
                                     const double *vertices, ptrdiff_t stride);

/* ---- One sample at a time ------------------------------------------------------------------ */

/** One sampled point of a light. */
typedef struct psc_light_sample_f64 {
    double direction[3]; /**< unit vector from the receiver to the light */
    double pdf;          /**< density of the direction per steradian */
    double point[3];     /**< the point on the light, in world space */
    double distance;     /**< from the receiver to the point */
    double normal[3];    /**< unit outward normal of the light at the point */
    double weight;       /**< cosine / pdf, or 1 / pdf for a receiver without normal; finite
                              and right where both cosine and pdf vanish; 0 when culled */
    double surface[2];   /**< texture coordinates of shapes that have their own: disks and
                              ellipses (s, t) in [-1,1] along their axes; spheres, caps and
                              ellipsoids have none and write 0 */
} psc_light_sample_f64;

/** The same in single precision. */
typedef struct psc_light_sample_f32 {
    float direction[3];
    float pdf;
    float point[3];
    float distance;
    float normal[3];
    float weight;
    float surface[2];
} psc_light_sample_f32;

/**
 * Samples one direction. Checks none of its pointers.
 * @param u,v  a point of the unit square, uniformly distributed if the samples are to be
 * @return PSC_SUCCESS, PSC_CULLED or PSC_EMPTY
 * @since 0.1
 */
PSC_API psc_result psc_sample_f64(const psc_sampler *sampler, double u, double v,
                                  psc_light_sample_f64 *sample);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_sample_f32(const psc_sampler *sampler, float u, float v,
                                  psc_light_sample_f32 *sample);

/**
 * The density with which psc_sample_f64() gives a direction, for multiple importance sampling:
 * exactly 0 outside the support. At the limb of a sphere sampled by visible area, where the
 * density of a sample is infinite, it is that of a direction a rounding inside. Checks none of
 * its pointers.
 * @param direction  unit vector from the receiver
 * @param pdf        receives the density per steradian
 * @return PSC_SUCCESS, or PSC_EMPTY (with pdf 0)
 * @since 0.1
 */
PSC_API psc_result psc_pdf_f64(const psc_sampler *sampler, const double direction[3], double *pdf);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_pdf_f32(const psc_sampler *sampler, const float direction[3], float *pdf);

/**
 * The point of the unit square that psc_sample_f64() maps to a direction: the exact inverse.
 * Checks none of its pointers. Where a light is seen as small as the rounding of the direction,
 * the result is as good as the direction that was passed.
 * @param direction  unit vector from the receiver
 * @param uv         receives the point
 * @return PSC_SUCCESS, PSC_OUTSIDE or PSC_EMPTY
 * @since 0.1
 */
PSC_API psc_result psc_invert_f64(const psc_sampler *sampler, const double direction[3],
                                  double uv[2]);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_invert_f32(const psc_sampler *sampler, const float direction[3],
                                  float uv[2]);

/* ---- Arrays -------------------------------------------------------------------------------- */

/**
 * Arrays are described by one pointer per component and one stride in bytes that all of them
 * share, so that interleaved records, separate arrays and strided views pass without a copy.
 * Element i of component c is at (char *)component[c] + i * stride. Scalars use component[0],
 * pairs the first two, vectors all three; the others are not read. Numbers must be naturally
 * aligned; strides may be negative. A stride of 0 repeats one value for every element of an
 * input. An output component that is NULL is not wanted. Outputs must not overlap inputs.
 */
typedef struct psc_input_f64 {
    const double *component[3];
    ptrdiff_t stride;
} psc_input_f64;

typedef struct psc_input_f32 {
    const float *component[3];
    ptrdiff_t stride;
} psc_input_f32;

typedef struct psc_output_f64 {
    double *component[3];
    ptrdiff_t stride;
} psc_output_f64;

typedef struct psc_output_f32 {
    float *component[3];
    ptrdiff_t stride;
} psc_output_f32;

/** An array of statuses; element i is at (char *)data + i * stride. NULL: not wanted. */
typedef struct psc_output_result {
    psc_result *data;
    ptrdiff_t stride;
} psc_output_result;

/** Where sampled points go: the fields of psc_light_sample_f64, each an array or not wanted,
    and the result that psc_sample_f64() would have returned for each element. */
typedef struct psc_samples_f64 {
    uint32_t struct_size; /**< sizeof(psc_samples_f64) */
    uint32_t reserved;    /**< 0 */
    psc_output_f64 direction;
    psc_output_f64 pdf;
    psc_output_f64 point;
    psc_output_f64 distance;
    psc_output_f64 normal;
    psc_output_f64 weight;
    psc_output_f64 surface;
    psc_output_result status;
} psc_samples_f64;

/** The same in single precision. */
typedef struct psc_samples_f32 {
    uint32_t struct_size; /**< sizeof(psc_samples_f32) */
    uint32_t reserved;    /**< 0 */
    psc_output_f32 direction;
    psc_output_f32 pdf;
    psc_output_f32 point;
    psc_output_f32 distance;
    psc_output_f32 normal;
    psc_output_f32 weight;
    psc_output_f32 surface;
    psc_output_result status;
} psc_samples_f32;

/**
 * Samples one build many times: element for element, to the last bit, what psc_sample_f64()
 * gives.
 * @param count  number of elements; may be 0
 * @param uv     pairs: points of the unit square
 * @param out    what is wanted of the samples
 * @return PSC_SUCCESS; PSC_EMPTY (only the statuses are written); PSC_ERROR_NULL_POINTER,
 *         PSC_ERROR_STRUCT_SIZE or PSC_ERROR_UNKNOWN_FIELD
 * @since 0.1
 */
PSC_API psc_result psc_sample_n_f64(const psc_sampler *sampler, size_t count,
                                    const psc_input_f64 *uv, const psc_samples_f64 *out);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_sample_n_f32(const psc_sampler *sampler, size_t count,
                                    const psc_input_f32 *uv, const psc_samples_f32 *out);

/**
 * psc_pdf_f64() for many directions.
 * @param direction  vectors: unit, from the receiver
 * @param pdf        scalars
 * @return PSC_SUCCESS, PSC_EMPTY (all pdfs 0) or PSC_ERROR_NULL_POINTER
 * @since 0.1
 */
PSC_API psc_result psc_pdf_n_f64(const psc_sampler *sampler, size_t count,
                                 const psc_input_f64 *direction, const psc_output_f64 *pdf);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_pdf_n_f32(const psc_sampler *sampler, size_t count,
                                 const psc_input_f32 *direction, const psc_output_f32 *pdf);

/**
 * psc_invert_f64() for many directions.
 * @param direction  vectors: unit, from the receiver
 * @param uv         pairs; left as they were where the status is not PSC_SUCCESS
 * @param status     what psc_invert_f64() would have returned for each element; may be NULL
 * @return PSC_SUCCESS, PSC_EMPTY (only the statuses are written) or PSC_ERROR_NULL_POINTER
 * @since 0.1
 */
PSC_API psc_result psc_invert_n_f64(const psc_sampler *sampler, size_t count,
                                    const psc_input_f64 *direction, const psc_output_f64 *uv,
                                    const psc_output_result *status);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_invert_n_f32(const psc_sampler *sampler, size_t count,
                                    const psc_input_f32 *direction, const psc_output_f32 *uv,
                                    const psc_output_result *status);

/* ---- Wavefronts: one build and one sample per element -------------------------------------- */

/** Many receivers. */
typedef struct psc_receivers_f64 {
    uint32_t struct_size;   /**< sizeof(psc_receivers_f64) */
    uint32_t flags;         /**< as in psc_receiver, for all of them */
    psc_input_f64 position; /**< vectors */
    psc_input_f64 normal;   /**< vectors; component[0] NULL for points in a volume */
} psc_receivers_f64;

/** The same in single precision. */
typedef struct psc_receivers_f32 {
    uint32_t struct_size; /**< sizeof(psc_receivers_f32) */
    uint32_t flags;
    psc_input_f32 position;
    psc_input_f32 normal;
} psc_receivers_f32;

/**
 * For each element, builds the sampler of a sphere and samples it once: to the last bit what
 * psc_build_sphere() and psc_sample_f64() give, without a handle. Errors of single elements
 * (a NaN, a zero normal) are in the statuses and do not stop the others.
 * @param technique  one for all
 * @param count      number of elements; may be 0
 * @param receivers  positions and normals
 * @param center     vectors
 * @param radius     scalars
 * @param uv         pairs
 * @param out        what is wanted; left as it was where the status is an error or PSC_EMPTY
 * @return PSC_SUCCESS, or an error of the call as a whole: those of psc_build_sphere() that
 *         concern pointers, sizes and the technique
 * @since 0.1
 */
PSC_API psc_result psc_sphere_sample_n_f64(const psc_technique *technique, size_t count,
                                           const psc_receivers_f64 *receivers,
                                           const psc_input_f64 *center,
                                           const psc_input_f64 *radius, const psc_input_f64 *uv,
                                           const psc_samples_f64 *out);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_sphere_sample_n_f32(const psc_technique *technique, size_t count,
                                           const psc_receivers_f32 *receivers,
                                           const psc_input_f32 *center,
                                           const psc_input_f32 *radius, const psc_input_f32 *uv,
                                           const psc_samples_f32 *out);

/** psc_build_cap() and psc_sample_f64() for each element; see psc_sphere_sample_n_f64().
    @since 0.1 */
PSC_API psc_result psc_cap_sample_n_f64(const psc_technique *technique, size_t count,
                                        const psc_receivers_f64 *receivers,
                                        const psc_input_f64 *axis,
                                        const psc_input_f64 *half_angle, const psc_input_f64 *uv,
                                        const psc_samples_f64 *out);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_cap_sample_n_f32(const psc_technique *technique, size_t count,
                                        const psc_receivers_f32 *receivers,
                                        const psc_input_f32 *axis,
                                        const psc_input_f32 *half_angle, const psc_input_f32 *uv,
                                        const psc_samples_f32 *out);

/** psc_build_disk() and psc_sample_f64() for each element; see psc_sphere_sample_n_f64().
    @since 0.1 */
PSC_API psc_result psc_disk_sample_n_f64(const psc_technique *technique, size_t count,
                                         const psc_receivers_f64 *receivers,
                                         const psc_input_f64 *center, const psc_input_f64 *normal,
                                         const psc_input_f64 *radius, const psc_input_f64 *uv,
                                         const psc_samples_f64 *out);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_disk_sample_n_f32(const psc_technique *technique, size_t count,
                                         const psc_receivers_f32 *receivers,
                                         const psc_input_f32 *center, const psc_input_f32 *normal,
                                         const psc_input_f32 *radius, const psc_input_f32 *uv,
                                         const psc_samples_f32 *out);

/** psc_build_ellipse() and psc_sample_f64() for each element; see psc_sphere_sample_n_f64().
    @since 0.1 */
PSC_API psc_result psc_ellipse_sample_n_f64(const psc_technique *technique, size_t count,
                                            const psc_receivers_f64 *receivers,
                                            const psc_input_f64 *center,
                                            const psc_input_f64 *axis_u,
                                            const psc_input_f64 *axis_v, const psc_input_f64 *uv,
                                            const psc_samples_f64 *out);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_ellipse_sample_n_f32(const psc_technique *technique, size_t count,
                                            const psc_receivers_f32 *receivers,
                                            const psc_input_f32 *center,
                                            const psc_input_f32 *axis_u,
                                            const psc_input_f32 *axis_v, const psc_input_f32 *uv,
                                            const psc_samples_f32 *out);

/** psc_build_ellipsoid() and psc_sample_f64() for each element; see psc_sphere_sample_n_f64().
    @since 0.1 */
PSC_API psc_result psc_ellipsoid_sample_n_f64(const psc_technique *technique, size_t count,
                                              const psc_receivers_f64 *receivers,
                                              const psc_input_f64 *center,
                                              const psc_input_f64 *axis_u,
                                              const psc_input_f64 *axis_v,
                                              const psc_input_f64 *axis_w, const psc_input_f64 *uv,
                                              const psc_samples_f64 *out);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_ellipsoid_sample_n_f32(const psc_technique *technique, size_t count,
                                              const psc_receivers_f32 *receivers,
                                              const psc_input_f32 *center,
                                              const psc_input_f32 *axis_u,
                                              const psc_input_f32 *axis_v,
                                              const psc_input_f32 *axis_w, const psc_input_f32 *uv,
                                              const psc_samples_f32 *out);

/** psc_build_triangle() and psc_sample_f64() for each element; see psc_sphere_sample_n_f64().
    @since 0.1 */
PSC_API psc_result psc_triangle_sample_n_f64(const psc_technique *technique, size_t count,
                                             const psc_receivers_f64 *receivers,
                                             const psc_input_f64 *v0, const psc_input_f64 *v1,
                                             const psc_input_f64 *v2, const psc_input_f64 *uv,
                                             const psc_samples_f64 *out);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_triangle_sample_n_f32(const psc_technique *technique, size_t count,
                                             const psc_receivers_f32 *receivers,
                                             const psc_input_f32 *v0, const psc_input_f32 *v1,
                                             const psc_input_f32 *v2, const psc_input_f32 *uv,
                                             const psc_samples_f32 *out);

/** psc_build_rectangle() and psc_sample_f64() for each element; see psc_sphere_sample_n_f64().
    @since 0.1 */
PSC_API psc_result psc_rectangle_sample_n_f64(const psc_technique *technique, size_t count,
                                              const psc_receivers_f64 *receivers,
                                              const psc_input_f64 *corner,
                                              const psc_input_f64 *edge_u,
                                              const psc_input_f64 *edge_v,
                                              const psc_input_f64 *uv,
                                              const psc_samples_f64 *out);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_rectangle_sample_n_f32(const psc_technique *technique, size_t count,
                                              const psc_receivers_f32 *receivers,
                                              const psc_input_f32 *corner,
                                              const psc_input_f32 *edge_u,
                                              const psc_input_f32 *edge_v,
                                              const psc_input_f32 *uv,
                                              const psc_samples_f32 *out);

/** psc_build_polygon() and psc_sample_f64() for each element; see psc_sphere_sample_n_f64().
    All have vertex_count vertices, 3 to 16; vertices has that many inputs, of vectors.
    @since 0.1 */
PSC_API psc_result psc_polygon_sample_n_f64(const psc_technique *technique, size_t count,
                                            const psc_receivers_f64 *receivers,
                                            size_t vertex_count, const psc_input_f64 *vertices,
                                            const psc_input_f64 *uv, const psc_samples_f64 *out);
/** The same in single precision. @since 0.1 */
PSC_API psc_result psc_polygon_sample_n_f32(const psc_technique *technique, size_t count,
                                            const psc_receivers_f32 *receivers,
                                            size_t vertex_count, const psc_input_f32 *vertices,
                                            const psc_input_f32 *uv, const psc_samples_f32 *out);

/* ---- Questions ------------------------------------------------------------------------------ */

/** The shape a sampler was built for. */
typedef uint32_t psc_shape;

enum {
    PSC_SHAPE_NONE = 0,
    PSC_SHAPE_SPHERE = 1,
    PSC_SHAPE_CAP = 2,
    PSC_SHAPE_DISK = 3,
    PSC_SHAPE_ELLIPSE = 4,
    PSC_SHAPE_ELLIPSOID = 5,
    PSC_SHAPE_TRIANGLE = 6,
    PSC_SHAPE_RECTANGLE = 7,
    PSC_SHAPE_POLYGON = 8
};

/** How the light lies to the horizon of the receiver; for spheres and caps the names are those of
    [UG18], after the outline of the light's projection on the receiver's tangent plane. */
typedef uint32_t psc_case;

enum {
    PSC_CASE_EMPTY = 0,            /**< nothing visible, or nothing built */
    PSC_CASE_ELLIPSE = 1,          /**< wholly above the horizon */
    PSC_CASE_ELLIPSE_AND_LUNE = 2, /**< partly below, its centre above or on the horizon */
    PSC_CASE_LUNE = 3,             /**< partly below, its centre too */
    PSC_CASE_INSIDE = 4,           /**< the receiver is inside the light */
    PSC_CASE_NO_HORIZON = 5,       /**< the receiver has no normal */
    PSC_CASE_ABOVE = 6,            /**< other shapes: wholly above the horizon */
    PSC_CASE_CLIPPED = 7           /**< other shapes: partly below */
};

/** What a sampler is. */
typedef struct psc_description {
    uint32_t struct_size; /**< set by the caller to sizeof(psc_description) */
    psc_shape shape;
    psc_measure measure;
    psc_map map;
    psc_case visibility; /**< for a two-sided receiver: seen from the side of the centre */
    uint32_t reserved;   /**< written as 0 */
} psc_description;

/**
 * Describes the sampler.
 * @return PSC_SUCCESS, PSC_EMPTY (written too), PSC_ERROR_NULL_POINTER, PSC_ERROR_STRUCT_SIZE
 * @since 0.1
 */
PSC_API psc_result psc_sampler_describe(const psc_sampler *sampler, psc_description *description);

/**
 * The total in the measure that the sampler is uniform in: steradians, or squared lengths for
 * the area measures.
 * @return PSC_SUCCESS, PSC_EMPTY (with 0) or PSC_ERROR_NULL_POINTER
 * @since 0.1
 */
PSC_API psc_result psc_sampler_total(const psc_sampler *sampler, double *total);

/** Solid angle of the whole light in steradians, whether above the horizon or not. Samplers by
    another measure may have to look at the light anew, which costs as much as building one.
    @return as psc_sampler_total() @since 0.1 */
PSC_API psc_result psc_sampler_solid_angle(const psc_sampler *sampler, double *solid_angle);

/** Integral of the cosine over the light above the horizon (over all of it, with |cosine|, for
    a two-sided receiver): 0 to pi (2 pi) steradians. [UG18, equations 27 to 29]
    @return as psc_sampler_total(), or PSC_ERROR_NEEDS_NORMAL, PSC_ERROR_HALF_ANGLE (a cap beyond
    a right angle), PSC_ERROR_UNSUPPORTED_TECHNIQUE (triangles, rectangles, polygons) @since 0.1 */
PSC_API psc_result psc_sampler_projected_solid_angle(const psc_sampler *sampler,
                                                     double *projected_solid_angle);

/** The projected solid angle divided by pi: the share of the receiver's cosine-weighted
    hemisphere that the light fills.
    @return as psc_sampler_projected_solid_angle() @since 0.1 */
PSC_API psc_result psc_sampler_form_factor(const psc_sampler *sampler, double *form_factor);

/** Surface area of the whole light in squared lengths.
    @return as psc_sampler_total(), or PSC_ERROR_UNSUPPORTED_TECHNIQUE for a distant light, which
    has none, and for an ellipsoid @since 0.1 */
PSC_API psc_result psc_sampler_area(const psc_sampler *sampler, double *area);

/**
 * Solid angle of a sphere without a sampler, in steradians: 4 pi from inside, 2 pi on the
 * surface.
 * @param position  of the receiver, 3 finite numbers
 * @return PSC_SUCCESS, PSC_EMPTY (radius 0; 0 is written), PSC_ERROR_NULL_POINTER,
 *         PSC_ERROR_NOT_FINITE, PSC_ERROR_NEGATIVE_SIZE
 * @since 0.1
 */
PSC_API psc_result psc_sphere_solid_angle(const double position[3], const double center[3],
                                          double radius, double *solid_angle);

/** Form factor from the receiver to a sphere, see psc_sampler_form_factor(), without a sampler.
    @return as psc_build_sphere(); 0 is written with PSC_EMPTY @since 0.1 */
PSC_API psc_result psc_sphere_form_factor(const psc_receiver *receiver, const double center[3],
                                          double radius, double *form_factor);

/** Solid angle of a cap of directions, in steradians.
    @return as psc_sphere_solid_angle(), or PSC_ERROR_HALF_ANGLE above pi @since 0.1 */
PSC_API psc_result psc_cap_solid_angle(double half_angle, double *solid_angle);

/** Form factor from the receiver to a distant light, without a sampler.
    @return as psc_build_cap(); 0 is written with PSC_EMPTY @since 0.1 */
PSC_API psc_result psc_cap_form_factor(const psc_receiver *receiver, const double axis[3],
                                       double half_angle, double *form_factor);

/**
 * Solid angle of a disk, of both its faces, without a sampler, in steradians.
 * @return PSC_SUCCESS; PSC_EMPTY (radius 0, or the receiver in its plane; 0 is written);
 *         PSC_ERROR_NULL_POINTER, _NOT_FINITE, _ZERO_VECTOR or _NEGATIVE_SIZE
 * @since 0.1
 */
PSC_API psc_result psc_disk_solid_angle(const double position[3], const double center[3],
                                        const double normal[3], double radius,
                                        double *solid_angle);

/** Solid angle of an elliptical disk without a sampler.
    @return as psc_disk_solid_angle() @since 0.1 */
PSC_API psc_result psc_ellipse_solid_angle(const double position[3], const double center[3],
                                           const double axis_u[3], const double axis_v[3],
                                           double *solid_angle);

/** Solid angle of an ellipsoid without a sampler: 4 pi from inside, 2 pi on the surface.
    @return as psc_disk_solid_angle() @since 0.1 */
PSC_API psc_result psc_ellipsoid_solid_angle(const double position[3], const double center[3],
                                             const double axis_u[3], const double axis_v[3],
                                             const double axis_w[3], double *solid_angle);

/**
 * Solid angle of a triangle without a sampler, in steradians: up to 2 pi close to it, to 1e-15 of
 * itself however small it is. Both sides count. [OS83]
 * @param position  of the receiver, 3 finite numbers
 * @return PSC_SUCCESS, PSC_EMPTY (no area, or seen edge-on; 0 is written),
 *         PSC_ERROR_NULL_POINTER, PSC_ERROR_NOT_FINITE
 * @since 0.1
 */
PSC_API psc_result psc_triangle_solid_angle(const double position[3], const double v0[3],
                                            const double v1[3], const double v2[3],
                                            double *solid_angle);

/** Form factor from the receiver to a triangle, see psc_sampler_form_factor(), without a sampler:
    the part above its horizon counts, both parts for a two-sided receiver.
    @return as psc_build_triangle() by projected solid angle; 0 is written with PSC_EMPTY
    @since 0.1 */
PSC_API psc_result psc_triangle_form_factor(const psc_receiver *receiver, const double v0[3],
                                            const double v1[3], const double v2[3],
                                            double *form_factor);

/** Solid angle of a rectangle without a sampler, in steradians; see psc_build_rectangle().
    @return as psc_triangle_solid_angle(), or PSC_ERROR_NOT_RECTANGLE @since 0.1 */
PSC_API psc_result psc_rectangle_solid_angle(const double position[3], const double corner[3],
                                             const double edge_u[3], const double edge_v[3],
                                             double *solid_angle);

/** Form factor from the receiver to a rectangle, without a sampler.
    @return as psc_build_rectangle(); 0 is written with PSC_EMPTY @since 0.1 */
PSC_API psc_result psc_rectangle_form_factor(const psc_receiver *receiver, const double corner[3],
                                             const double edge_u[3], const double edge_v[3],
                                             double *form_factor);

/** Solid angle of a convex polygon without a sampler, in steradians; see psc_build_polygon().
    @return as psc_triangle_solid_angle(), or PSC_ERROR_VERTEX_COUNT, PSC_ERROR_NOT_PLANAR,
    PSC_ERROR_NOT_CONVEX @since 0.1 */
PSC_API psc_result psc_polygon_solid_angle(const double position[3], size_t count,
                                           const double *vertices, ptrdiff_t stride,
                                           double *solid_angle);

/** Form factor from the receiver to a convex polygon, without a sampler.
    @return as psc_build_polygon(); 0 is written with PSC_EMPTY @since 0.1 */
PSC_API psc_result psc_polygon_form_factor(const psc_receiver *receiver, size_t count,
                                           const double *vertices, ptrdiff_t stride,
                                           double *form_factor);

/** Form factor from the receiver to a disk, see psc_sampler_form_factor(), without a sampler: from
    either side of the disk, to 3e-15 of itself whether the horizon cuts the disk or not.
    @return as psc_build_disk(); 0 is written with PSC_EMPTY @since 0.1 */
PSC_API psc_result psc_disk_form_factor(const psc_receiver *receiver, const double center[3],
                                        const double normal[3], double radius,
                                        double *form_factor);

/** Form factor from the receiver to an elliptical disk, without a sampler.
    @return as psc_build_ellipse(); 0 is written with PSC_EMPTY @since 0.1 */
PSC_API psc_result psc_ellipse_form_factor(const psc_receiver *receiver, const double center[3],
                                           const double axis_u[3], const double axis_v[3],
                                           double *form_factor);

/** Form factor from the receiver to an ellipsoid, without a sampler: 1 from inside, for each side
    of the receiver that is lit.
    @return as psc_build_ellipsoid(); 0 is written with PSC_EMPTY @since 0.1 */
PSC_API psc_result psc_ellipsoid_form_factor(const psc_receiver *receiver, const double center[3],
                                             const double axis_u[3], const double axis_v[3],
                                             const double axis_w[3], double *form_factor);

/* ---- The table of the tabulated map ---------------------------------------------------------- */

/** Bytes that psc_table_init() needs; 0 for a resolution that it does not take. @since 0.1 */
PSC_API size_t psc_table_size(uint32_t resolution);

/**
 * Makes the table of PSC_MAP_TABULATED in the caller's memory: once, for all lights and threads, to
 * be read only from then on. It has as many rows, for the quotient of the semi-arcs, as columns.
 *
 * u and v are e1 and e2 of the radial map. Its angle is looked up, linear within a column, and the
 * direction is then uniform in a sector that covers the light there: some points of the square miss
 * it. They are PSC_CULLED, with weight and pdf 0, a direction on the outline, and count as samples.
 * The pdf is the density that the sector has, not one over the solid angle as in the paper, so that
 * no bias is left. It jumps from column to column, and the map with it. The inverse is exact.
 *
 * Measured: samples that miss, and the range of pdf times solid angle, for semi-arcs in degrees.
 *
 *     resolution     size   1, 0.1       15, 5        45, 10       75, 10       89, 20
 *             64    16 KiB  7.0 %        2.0 %        3.1 %        5.3 %        3.3 %
 *                           .88-1.03     .97-1.01     .94-1.02     .93-.96      .81-1.10
 *            256   257 KiB  1.9 %        0.5 %        0.8 %        1.4 %        0.8 %
 *                           .96-1.03     .99-1.003    .98-1.01     .90-1.04     .84-1.11
 *           1024   4.1 MiB  0.5 %        0.1 %        0.2 %        0.3 %        0.2 %
 *                           .99-1.007    .99-1.006    .98-1.01     .91-1.05     .84-1.12
 *
 * The error does not go away with resolution: the row is the nearest one, and for alpha = 0.5
 * whatever alpha is. Lights thinner than a row go wrong: at 1, 1e-4 degrees and 1024, 70 % miss and
 * pdf times solid angle is .065-9.99.
 * PSC_MAP_RADIAL is exact and faster; so is PSC_MAP_QUASI_UNIFORM, and closer to uniform.
 * @param memory      psc_table_size() bytes or more, aligned as a uint32_t; owned by the caller
 * @param size        bytes at memory
 * @param resolution  2 to 1024, which is what [GUK17] takes
 * @param out         receives the table, or NULL on failure
 * @return PSC_ERROR_NULL_POINTER, PSC_ERROR_RESOLUTION, or PSC_ERROR_STORAGE when memory is too
 *         small or misaligned
 * @since 0.1
 */
PSC_API psc_result psc_table_init(void *memory, size_t size, uint32_t resolution,
                                  const psc_table **out);

/* ---- The function table, for programs that load the library at run time ----------------------- */

/** Every function above, in the order of this header. The table only ever grows at its end. */
typedef struct psc_api_1 {
    uint32_t (*version)(void);
    const char *(*result_string)(psc_result);
    size_t (*sampler_size)(void);
    size_t (*sampler_align)(void);
    psc_result (*sampler_init)(void *, size_t, psc_sampler **);
    psc_result (*sampler_create)(const psc_allocator *, psc_sampler **);
    void (*sampler_destroy)(psc_sampler *);
    psc_result (*build_sphere)(psc_sampler *, const psc_technique *, const psc_receiver *,
                               const double *, double);
    psc_result (*build_cap)(psc_sampler *, const psc_technique *, const psc_receiver *,
                            const double *, double);
    psc_result (*build_disk)(psc_sampler *, const psc_technique *, const psc_receiver *,
                             const double *, const double *, double);
    psc_result (*build_ellipse)(psc_sampler *, const psc_technique *, const psc_receiver *,
                                const double *, const double *, const double *);
    psc_result (*build_ellipsoid)(psc_sampler *, const psc_technique *, const psc_receiver *,
                                  const double *, const double *, const double *, const double *);
    psc_result (*build_triangle)(psc_sampler *, const psc_technique *, const psc_receiver *,
                                 const double *, const double *, const double *);
    psc_result (*build_rectangle)(psc_sampler *, const psc_technique *, const psc_receiver *,
                                  const double *, const double *, const double *);
    psc_result (*build_polygon)(psc_sampler *, const psc_technique *, const psc_receiver *, size_t,
                                const double *, ptrdiff_t);
    psc_result (*sample_f64)(const psc_sampler *, double, double, psc_light_sample_f64 *);
    psc_result (*sample_f32)(const psc_sampler *, float, float, psc_light_sample_f32 *);
    psc_result (*pdf_f64)(const psc_sampler *, const double *, double *);
    psc_result (*pdf_f32)(const psc_sampler *, const float *, float *);
    psc_result (*invert_f64)(const psc_sampler *, const double *, double *);
    psc_result (*invert_f32)(const psc_sampler *, const float *, float *);
    psc_result (*sample_n_f64)(const psc_sampler *, size_t, const psc_input_f64 *,
                               const psc_samples_f64 *);
    psc_result (*sample_n_f32)(const psc_sampler *, size_t, const psc_input_f32 *,
                               const psc_samples_f32 *);
    psc_result (*pdf_n_f64)(const psc_sampler *, size_t, const psc_input_f64 *,
                            const psc_output_f64 *);
    psc_result (*pdf_n_f32)(const psc_sampler *, size_t, const psc_input_f32 *,
                            const psc_output_f32 *);
    psc_result (*invert_n_f64)(const psc_sampler *, size_t, const psc_input_f64 *,
                               const psc_output_f64 *, const psc_output_result *);
    psc_result (*invert_n_f32)(const psc_sampler *, size_t, const psc_input_f32 *,
                               const psc_output_f32 *, const psc_output_result *);
    psc_result (*sphere_sample_n_f64)(const psc_technique *, size_t, const psc_receivers_f64 *,
                                      const psc_input_f64 *, const psc_input_f64 *,
                                      const psc_input_f64 *, const psc_samples_f64 *);
    psc_result (*sphere_sample_n_f32)(const psc_technique *, size_t, const psc_receivers_f32 *,
                                      const psc_input_f32 *, const psc_input_f32 *,
                                      const psc_input_f32 *, const psc_samples_f32 *);
    psc_result (*cap_sample_n_f64)(const psc_technique *, size_t, const psc_receivers_f64 *,
                                   const psc_input_f64 *, const psc_input_f64 *,
                                   const psc_input_f64 *, const psc_samples_f64 *);
    psc_result (*cap_sample_n_f32)(const psc_technique *, size_t, const psc_receivers_f32 *,
                                   const psc_input_f32 *, const psc_input_f32 *,
                                   const psc_input_f32 *, const psc_samples_f32 *);
    psc_result (*disk_sample_n_f64)(const psc_technique *, size_t, const psc_receivers_f64 *,
                                    const psc_input_f64 *, const psc_input_f64 *,
                                    const psc_input_f64 *, const psc_input_f64 *,
                                    const psc_samples_f64 *);
    psc_result (*disk_sample_n_f32)(const psc_technique *, size_t, const psc_receivers_f32 *,
                                    const psc_input_f32 *, const psc_input_f32 *,
                                    const psc_input_f32 *, const psc_input_f32 *,
                                    const psc_samples_f32 *);
    psc_result (*ellipse_sample_n_f64)(const psc_technique *, size_t, const psc_receivers_f64 *,
                                       const psc_input_f64 *, const psc_input_f64 *,
                                       const psc_input_f64 *, const psc_input_f64 *,
                                       const psc_samples_f64 *);
    psc_result (*ellipse_sample_n_f32)(const psc_technique *, size_t, const psc_receivers_f32 *,
                                       const psc_input_f32 *, const psc_input_f32 *,
                                       const psc_input_f32 *, const psc_input_f32 *,
                                       const psc_samples_f32 *);
    psc_result (*ellipsoid_sample_n_f64)(const psc_technique *, size_t, const psc_receivers_f64 *,
                                         const psc_input_f64 *, const psc_input_f64 *,
                                         const psc_input_f64 *, const psc_input_f64 *,
                                         const psc_input_f64 *, const psc_samples_f64 *);
    psc_result (*ellipsoid_sample_n_f32)(const psc_technique *, size_t, const psc_receivers_f32 *,
                                         const psc_input_f32 *, const psc_input_f32 *,
                                         const psc_input_f32 *, const psc_input_f32 *,
                                         const psc_input_f32 *, const psc_samples_f32 *);
    psc_result (*triangle_sample_n_f64)(const psc_technique *, size_t, const psc_receivers_f64 *,
                                        const psc_input_f64 *, const psc_input_f64 *,
                                        const psc_input_f64 *, const psc_input_f64 *,
                                        const psc_samples_f64 *);
    psc_result (*triangle_sample_n_f32)(const psc_technique *, size_t, const psc_receivers_f32 *,
                                        const psc_input_f32 *, const psc_input_f32 *,
                                        const psc_input_f32 *, const psc_input_f32 *,
                                        const psc_samples_f32 *);
    psc_result (*rectangle_sample_n_f64)(const psc_technique *, size_t, const psc_receivers_f64 *,
                                         const psc_input_f64 *, const psc_input_f64 *,
                                         const psc_input_f64 *, const psc_input_f64 *,
                                         const psc_samples_f64 *);
    psc_result (*rectangle_sample_n_f32)(const psc_technique *, size_t, const psc_receivers_f32 *,
                                         const psc_input_f32 *, const psc_input_f32 *,
                                         const psc_input_f32 *, const psc_input_f32 *,
                                         const psc_samples_f32 *);
    psc_result (*polygon_sample_n_f64)(const psc_technique *, size_t, const psc_receivers_f64 *,
                                       size_t, const psc_input_f64 *, const psc_input_f64 *,
                                       const psc_samples_f64 *);
    psc_result (*polygon_sample_n_f32)(const psc_technique *, size_t, const psc_receivers_f32 *,
                                       size_t, const psc_input_f32 *, const psc_input_f32 *,
                                       const psc_samples_f32 *);
    psc_result (*sampler_describe)(const psc_sampler *, psc_description *);
    psc_result (*sampler_total)(const psc_sampler *, double *);
    psc_result (*sampler_solid_angle)(const psc_sampler *, double *);
    psc_result (*sampler_projected_solid_angle)(const psc_sampler *, double *);
    psc_result (*sampler_form_factor)(const psc_sampler *, double *);
    psc_result (*sampler_area)(const psc_sampler *, double *);
    psc_result (*sphere_solid_angle)(const double *, const double *, double, double *);
    psc_result (*sphere_form_factor)(const psc_receiver *, const double *, double, double *);
    psc_result (*cap_solid_angle)(double, double *);
    psc_result (*cap_form_factor)(const psc_receiver *, const double *, double, double *);
    psc_result (*disk_solid_angle)(const double *, const double *, const double *, double,
                                   double *);
    psc_result (*ellipse_solid_angle)(const double *, const double *, const double *,
                                      const double *, double *);
    psc_result (*ellipsoid_solid_angle)(const double *, const double *, const double *,
                                        const double *, const double *, double *);
    psc_result (*triangle_solid_angle)(const double *, const double *, const double *,
                                       const double *, double *);
    psc_result (*triangle_form_factor)(const psc_receiver *, const double *, const double *,
                                       const double *, double *);
    psc_result (*rectangle_solid_angle)(const double *, const double *, const double *,
                                        const double *, double *);
    psc_result (*rectangle_form_factor)(const psc_receiver *, const double *, const double *,
                                        const double *, double *);
    psc_result (*polygon_solid_angle)(const double *, size_t, const double *, ptrdiff_t, double *);
    psc_result (*polygon_form_factor)(const psc_receiver *, size_t, const double *, ptrdiff_t,
                                      double *);
    psc_result (*disk_form_factor)(const psc_receiver *, const double *, const double *, double,
                                   double *);
    psc_result (*ellipse_form_factor)(const psc_receiver *, const double *, const double *,
                                      const double *, double *);
    psc_result (*ellipsoid_form_factor)(const psc_receiver *, const double *, const double *,
                                        const double *, const double *, double *);
    size_t (*table_size)(uint32_t);
    psc_result (*table_init)(void *, size_t, uint32_t, const psc_table **);
} psc_api_1;

/**
 * Fills a table of function pointers: the one name a plugin host needs to look up. Every library
 * gives at least the first two functions, which say what is wrong when it cannot give all.
 * @param version  1
 * @param table    a psc_api_1, of which the first size bytes are written
 * @param size     sizeof(psc_api_1) as the caller knows it
 * @return PSC_SUCCESS; PSC_ERROR_NULL_POINTER; PSC_ERROR_STRUCT_SIZE when size is not that of
 *         whole functions; PSC_ERROR_UNKNOWN_VERSION when the caller's header is newer than the
 *         library
 * @since 0.1
 */
PSC_API psc_result psc_get_api(uint32_t version, void *table, size_t size);

#ifdef __cplusplus
}
#endif

#endif
