/* SPDX-License-Identifier: Apache-2.0 */
#include <psc/psc.h>

uint32_t psc_version(void)
{
    return PSC_VERSION;
}

const char *psc_result_string(psc_result result)
{
    switch (result) {
    case PSC_SUCCESS: return "success";
    case PSC_EMPTY: return "nothing of the light is visible from the receiver";
    case PSC_CULLED: return "the sample is below the horizon or on the far side of the light";
    case PSC_OUTSIDE: return "the direction is not one that the sampler can give";
    case PSC_ERROR_NULL_POINTER: return "a pointer that must point to something is NULL";
    case PSC_ERROR_STRUCT_SIZE: return "struct_size is not the size of any known version";
    case PSC_ERROR_UNKNOWN_FIELD: return "a field that this version does not know is not zero";
    case PSC_ERROR_STORAGE: return "memory for the sampler is too small or misaligned";
    case PSC_ERROR_OUT_OF_MEMORY: return "the allocator returned no memory";
    case PSC_ERROR_NOT_FINITE: return "a coordinate or length is NaN, infinite or too large";
    case PSC_ERROR_ZERO_VECTOR: return "a normal or axis has length zero";
    case PSC_ERROR_NEGATIVE_SIZE: return "a radius or half-angle is negative";
    case PSC_ERROR_HALF_ANGLE: return "the half-angle is above pi, or above a right angle where "
                                      "projected solid angle needs less";
    case PSC_ERROR_UNKNOWN_MEASURE: return "no such measure";
    case PSC_ERROR_UNKNOWN_MAP: return "no such map";
    case PSC_ERROR_UNKNOWN_FLAG: return "a flag is set that means nothing";
    case PSC_ERROR_UNSUPPORTED_TECHNIQUE: return "the shape does not offer this measure or map";
    case PSC_ERROR_NEEDS_NORMAL: return "projected solid angle needs a receiver with a normal";
    case PSC_ERROR_UNKNOWN_VERSION: return "no function table of this version and size: the library is "
                                           "older than the program";
    case PSC_ERROR_VERTEX_COUNT: return "a polygon has fewer than 3 or more than 16 vertices";
    case PSC_ERROR_NOT_PLANAR: return "the vertices of the polygon are not in one plane";
    case PSC_ERROR_NOT_CONVEX: return "the polygon is not convex";
    case PSC_ERROR_NOT_RECTANGLE: return "the edges of the rectangle are not perpendicular";
    case PSC_ERROR_NEEDS_TABLE: return "the tabulated map needs a table made by psc_table_init()";
    case PSC_ERROR_RESOLUTION: return "the resolution of a table is from 2 to 1024";
    default: return "unknown result";
    }
}
