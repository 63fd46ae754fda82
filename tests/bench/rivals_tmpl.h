/* SPDX-License-Identifier: Apache-2.0 */
/*
 * One run of each rival: a type, the numbers of its light, its build and its sample. Template: see
 * real.h; after runs_tmpl.h.
 */

#undef RIVAL
#define RIVAL(name, type, numbers, build, sample)                                            \
    static size_t FN(name)(struct job *job)                                                  \
    {                                                                                        \
        struct FN(stage) *s = STAGE_OF(job);                                                 \
        const size_t per = FN(per_build)(job, s);                                            \
        size_t i, j;                                                                         \
                                                                                             \
        for (i = 0; i < s->count; i += per) {                                                \
            const size_t from = per < s->count ? i : job->turn++ % s->count;                 \
            struct FN(type) built;                                                           \
            real position[3], normal[3], light[numbers], direction[3], pdf;                  \
            int c;                                                                           \
                                                                                             \
            FN(element)(s->position, from, position);                                        \
            FN(element)(s->normal, from, normal);                                            \
            for (c = 0; c < numbers; c++)                                                    \
                light[c] = s->light[c][from];                                                \
            if (FN(build)(&built, position, normal, light))                                  \
                for (j = i; j < i + per; j++) {                                              \
                    FN(sample)(&built, s->u[j], s->v[j], direction, &pdf);                   \
                    FN(put)(s, j, direction, pdf);                                           \
                }                                                                            \
        }                                                                                    \
        return s->count;                                                                     \
    }

/* Point, normal and distance go to a record, as psc_sample puts them. */
static struct FN(hit) {
    real point[3], normal[3], distance;
} FN(hits)[STAGE_MAX];

static inline void FN(cone_hit_sample)(const struct FN(cone) *c, real u, real v, real direction[3],
                                       real *pdf)
{
    static size_t turn;
    struct FN(hit) *hit = &FN(hits)[turn++ % STAGE_MAX];

    FN(cone_hit)(c, u, v, direction, pdf, hit->point, hit->normal, &hit->distance);
}

RIVAL(run_cone, cone, 4, cone_build, cone_sample)
RIVAL(run_cone_hit, cone, 4, cone_build, cone_hit_sample)
RIVAL(run_paper_radial, paper, 4, radial_build, radial_sample)
RIVAL(run_paper_parallel, paper, 4, parallel_build, parallel_sample)
RIVAL(run_triangle_arvo, triangle, 9, triangle_build, triangle_sample)
RIVAL(run_rectangle_ufk, rectangle, 9, rectangle_build, rectangle_sample)
RIVAL(run_pentagon_arvo, pentagon, 15, pentagon_build, pentagon_sample)
RIVAL(run_triangle_area, face, 9, triangle_area_build, triangle_area_sample)
RIVAL(run_rectangle_area, face, 9, rectangle_area_build, rectangle_area_sample)
RIVAL(run_pentagon_area, face, 15, pentagon_area_build, pentagon_area_sample)
