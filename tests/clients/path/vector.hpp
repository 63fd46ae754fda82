/* SPDX-License-Identifier: Apache-2.0 */
/* The path tracer's vectors and random numbers. */
#ifndef PATH_VECTOR_HPP
#define PATH_VECTOR_HPP

#include <array>
#include <cmath>
#include <cstdint>

constexpr float pi = 3.14159265f;

struct Vector {
    float x = 0, y = 0, z = 0;
};

inline Vector operator+(Vector a, Vector b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(Vector a, Vector b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator-(Vector a)
{
    return {-a.x, -a.y, -a.z};
}
inline Vector operator*(float s, Vector a)
{
    return {s * a.x, s * a.y, s * a.z};
}
inline float dot(Vector a, Vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(Vector a, Vector b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector unit(Vector a)
{
    return 1 / std::sqrt(dot(a, a)) * a;
}

/* To and from what the library takes. */
inline std::array<double, 3> wide(Vector a)
{
    return {a.x, a.y, a.z};
}
inline Vector narrow(const std::array<double, 3> &a)
{
    return {float(a[0]), float(a[1]), float(a[2])};
}

/* From coordinates about a unit vector to the world. */
inline Vector about(Vector n, float x, float y, float z)
{
    const Vector s = unit(std::fabs(n.x) > 0.6f ? cross(n, {0, 1, 0}) : cross(n, {1, 0, 0}));
    return x * s + y * cross(n, s) + z * n;
}

/* PCG: M. O'Neill, 2014. */
class Random {
public:
    explicit Random(std::uint64_t stream) : state(0), increment(2 * stream + 1)
    {
        next();
        state += 0x853c49e6748fea9bu;
        next();
    }
    /* In [0, 1). */
    float operator()()
    {
        return float(next() >> 8) * 0x1p-24f;
    }

private:
    std::uint32_t next()
    {
        const std::uint64_t old = state;
        state = old * 6364136223846793005u + increment;
        const auto x = std::uint32_t(((old >> 18) ^ old) >> 27), turn = std::uint32_t(old >> 59);
        return x >> turn | x << (-turn & 31);
    }
    std::uint64_t state, increment;
};

#endif
