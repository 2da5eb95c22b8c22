// SPDX-License-Identifier: Apache-2.0
#include "sim_core/rod/rod_kernel.h"

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

struct Vec {
    Lanes x, y, z;
};
inline Vec operator+(const Vec& a, const Vec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(const Vec& a, const Vec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(const Vec& a, const Lanes& s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Lanes dot(const Vec& a, const Vec& b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
inline Vec cross(const Vec& a, const Vec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec load(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z,
                std::size_t i) {
    return {load_lanes(&x[i]), load_lanes(&y[i]), load_lanes(&z[i])};
}

// A linear form in the four unknowns of one edge: scaled edge vector and twist angle.
struct Form {
    Lanes v[4];
};
inline Form form(const Vec& a, const Lanes& angle) {
    return {{a.x, a.y, a.z, angle}};
}

inline Form scaled(const Form& a, const Lanes& s) {
    return {{a.v[0] * s, a.v[1] * s, a.v[2] * s, a.v[3] * s}};
}

// Symmetric 4 x 4, lower triangle by rows: 00 10 11 20 21 22 30 31 32 33.
struct Symmetric {
    Lanes v[10];
};
struct Full {
    Lanes v[4][4];
};

inline void add_product(Symmetric& m, const Form& a, const Form& b) {  // (a b^T + b a^T) / 2, b may be a
    int k = 0;
    for (int r = 0; r < 4; ++r) {
        for (int c = 0; c <= r; ++c) m.v[k++] += 0.5 * (a.v[r] * b.v[c] + b.v[r] * a.v[c]);
    }
}
inline void add_product3(Symmetric& m, const Vec& a, const Vec& b) {  // a b^T + b a^T on the vector part
    m.v[0] += 2.0 * a.x * b.x;
    m.v[1] += a.y * b.x + b.y * a.x;
    m.v[2] += 2.0 * a.y * b.y;
    m.v[3] += a.z * b.x + b.z * a.x;
    m.v[4] += a.z * b.y + b.z * a.y;
    m.v[5] += 2.0 * a.z * b.z;
}
inline void add_square(Symmetric& m, const Form& a, const Lanes& factor) {
    int k = 0;
    for (int r = 0; r < 4; ++r) {
        const Lanes scaled = a.v[r] * factor;
        for (int c = 0; c <= r; ++c) m.v[k++] += scaled * a.v[c];
    }
}
inline void add_identity(Symmetric& m, const Lanes& factor) {
    m.v[0] += factor;
    m.v[2] += factor;
    m.v[5] += factor;
}
inline void add_product(Full& m, const Form& a, const Form& b) {
    for (int r = 0; r < 4; ++r) {
        for (int c = 0; c < 4; ++c) m.v[r][c] += a.v[r] * b.v[c];
    }
}
inline void add_product3(Full& m, const Vec& a, const Vec& b) {
    const Lanes p[3] = {a.x, a.y, a.z}, q[3] = {b.x, b.y, b.z};
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) m.v[r][c] += p[r] * q[c];
    }
}

inline void store(const Symmetric& m, const Lanes& scale, Block4* to) {
    // Columns of four joints: the symmetric block's column c holds entries (r, c).
    static constexpr int at[4][4] = {{0, 1, 3, 6}, {1, 2, 4, 7}, {3, 4, 5, 8}, {6, 7, 8, 9}};
    const Lanes squared = scale * scale;
    for (int c = 0; c < 4; ++c) {
        Lanes e[4];
        for (int r = 0; r < 4; ++r) {
            const int angles = (r == 3) + (c == 3);
            e[r] = angles == 2 ? m.v[at[c][r]] : m.v[at[c][r]] * (angles == 1 ? scale : squared);
        }
        transpose_lanes(e[0], e[1], e[2], e[3]);
        for (int j = 0; j < 4; ++j) to[j].column[c] = e[j];
    }
}

inline void store(const Full& m, const Lanes& scale_a, const Lanes& scale_b, Block4* to) {
    const Lanes both = scale_a * scale_b;
    for (int c = 0; c < 4; ++c) {
        Lanes e[4];
        for (int r = 0; r < 4; ++r) {
            e[r] = m.v[r][c];
            if (r < 3 && c < 3) e[r] *= both;
            if (r < 3 && c == 3) e[r] *= scale_a;
            if (r == 3 && c < 3) e[r] *= scale_b;
        }
        transpose_lanes(e[0], e[1], e[2], e[3]);
        for (int j = 0; j < 4; ++j) to[j].column[c] = e[j];
    }
}

inline void store_gradient(Lanes x, Lanes y, Lanes z, Lanes angle, double* to) {
    transpose_lanes(x, y, z, angle);
    store_lanes(to, x);
    store_lanes(to + 4, y);
    store_lanes(to + 8, z);
    store_lanes(to + 12, angle);
}

// Contribution of the natural curvature: F and G of docs/THEORY.md, section 1.1, from directors of edge a.
struct Natural {
    Vec f, g;            // whole
    Vec fa, ga, fb, gb;  // perpendicular to s, to t
    Lanes z, g0;         // t.f, t.g
};

// One pass over all joints.
// Long because: its intermediate values stay in registers, and parts of it would need most of them.
template <bool curved, bool hessian, bool each>
bool pass(const Rod::Tables& tables, const RodShape& shape, const double* bend, const double* twist,
          RodJointTerms& out) {
    const std::size_t joints = static_cast<std::size_t>(tables.segments) + 1;
    Lanes bend_sum = all_lanes(0), twist_sum = all_lanes(0), smallest = all_lanes(2.0);
    const Lanes zero = all_lanes(0), one = all_lanes(1);
    // 4 tan^2(a/2) - (1 - cos a)^2 2/3 = a^2 + O(a^6): equals the squared turning angle to higher order,
    // which doubles the accuracy of a bent rod and keeps the barrier against folding. Natural curvature is
    // measured by 2 tan(a/2) and keeps it.
    constexpr double flattening = curved ? 0.0 : 2.0 / 3.0;
    for (std::size_t i = 0; i < joints; i += 4) {
        const Vec s = load(shape.tx, shape.ty, shape.tz, i), t = load(shape.tx, shape.ty, shape.tz, i + 1);
        const Lanes scale_a = load_lanes(&shape.inverse[i]), scale_b = load_lanes(&shape.inverse[i + 1]);
        const Lanes stiff = load_lanes(bend + i), torsion = load_lanes(twist + i);
        const Lanes m = load_lanes(&shape.twist[i]), offset = m - load_lanes(&tables.rest_twist[i]);
        const Lanes c = dot(s, t), chi = 1.0 + c, ix = 1.0 / chi;
        smallest = chi < smallest ? chi : smallest;
        const Vec k = cross(s, t) * (2.0 * ix);
        const Vec pa = t - s * c, pb = s - t * c;
        const Lanes ix2 = ix * ix, f1 = stiff * (flattening * (1.0 - c) - 4.0 * ix2);
        Lanes moment = torsion * offset;
        // 1 - c without cancellation in a nearly straight rod.
        const Lanes versine = 0.5 * dot(s - t, s - t);
        const Lanes bent = stiff * versine * (2.0 * ix - 0.5 * flattening * versine);
        bend_sum += bent;
        if constexpr (each) store_lanes(&out.energy[i], bent);
        twist_sum += 0.5 * torsion * offset * offset;

        Natural q;
        Lanes angle_shared = zero;  // the part of the derivative common to both twist angles
        Vec grad_a = pa * f1, grad_b = pb * f1;
        if constexpr (curved) {
            const Lanes k1 = load_lanes(&tables.rest_1[i]), k2 = load_lanes(&tables.rest_2[i]);
            Lanes half_sine, half_cosine;
            for (int j = 0; j < 4; ++j) {
                double sine, cosine;
                math::sin_cos(0.5 * m[j], sine, cosine);
                half_sine[j] = sine;
                half_cosine[j] = cosine;
            }
            const Lanes w_real = -stiff * (k1 * half_cosine - k2 * half_sine);
            const Lanes w_imaginary = stiff * (k2 * half_cosine + k1 * half_sine);
            const Lanes real = -2.0 * ix * w_imaginary, imaginary = 2.0 * ix * w_real;
            const Vec d1 = load(shape.dx, shape.dy, shape.dz, i), d2 = cross(s, d1);
            q.f = d1 * real - d2 * imaginary;
            q.g = d1 * imaginary + d2 * real;
            q.fa = q.f;
            q.ga = q.g;
            q.z = dot(t, q.f);
            q.g0 = dot(t, q.g);
            q.fb = q.f - t * q.z;
            q.gb = q.g - t * q.g0;
            const Lanes natural = q.z + 0.5 * stiff * (k1 * k1 + k2 * k2);
            bend_sum += natural;
            if constexpr (each) store_lanes(&out.energy[i], bent + natural);
            grad_a = grad_a - q.fa * c - pa * (q.z * ix);
            grad_b = grad_b + q.fb - pb * (q.z * ix);
            moment += 0.5 * q.g0;  // multiplies the derivatives of m
            angle_shared = q.g0;
        }
        const Vec half_k = k * (0.5 * one);
        grad_a = (grad_a + half_k * moment) * scale_a;
        grad_b = (grad_b + half_k * moment) * scale_b;
        // Twist angle of a: g0 from the frame itself and -1 of m; of b: +1 of m.
        store_gradient(grad_a.x, grad_a.y, grad_a.z, angle_shared - moment, &out.gradient_a[4 * i]);
        store_gradient(grad_b.x, grad_b.y, grad_b.z, moment, &out.gradient_b[4 * i]);
        if constexpr (!hessian) continue;

        const Lanes f2 = stiff * (8.0 * ix2 * ix - flattening);
        const Form ma = form(half_k, -one), mb = form(half_k, one);
        const Form fpa = form(pa, zero), fpb = form(pb, zero);
        const Vec tau = (s + t) * ix;
        const Lanes quarter = -0.25 * moment;
        Lanes square = f2, identity_a = -f1 * c, identity_b = -f1 * c, mixed = -f1, twist_square = torsion;
        if constexpr (curved) {
            square += 2.0 * q.z * ix2;
            mixed += q.z * ix;
            identity_a += q.z * c * ix;
            identity_b += q.z * c * ix - q.z;
            twist_square -= 0.25 * q.z;
        }
        Symmetric aa{}, bb{};
        Full ab{};
        add_square(aa, fpa, square);
        add_square(aa, ma, twist_square);
        add_product3(aa, s, pa * mixed - s * (0.5 * identity_a));
        add_identity(aa, identity_a);
        add_product3(aa, k, (s + tau) * quarter);
        add_square(bb, fpb, square);
        add_square(bb, mb, twist_square);
        add_product3(bb, t, pb * mixed - t * (0.5 * identity_b));
        add_identity(bb, identity_b);
        add_product3(bb, k, (t + tau) * quarter);
        // (I - s s^T)(I - t t^T) = I - s pb^T - t t^T.
        Lanes cross_factor = f1;
        if constexpr (curved) cross_factor -= q.z * ix;
        add_product3(ab, s, pb * (-cross_factor));
        add_product3(ab, t, t * (-cross_factor));
        for (int r = 0; r < 3; ++r) ab.v[r][r] += cross_factor;
        add_product(ab, form(pa * square, zero), fpb);
        add_product(ab, form(half_k * twist_square, -twist_square), mb);
        add_product3(ab, k * (-0.5 * moment), tau);
        const Vec turn = s * (moment * ix);  // moment / 2 * (2 / chi) [s]x
        ab.v[0][1] -= turn.z;
        ab.v[0][2] += turn.y;
        ab.v[1][0] += turn.z;
        ab.v[1][2] -= turn.x;
        ab.v[2][0] -= turn.y;
        ab.v[2][1] += turn.x;
        if constexpr (curved) {
            const Form gb = form(q.gb, zero), angle = form({zero, zero, zero}, one);
            const Form ha = form(q.ga * c + pa * (q.g0 * ix), q.z), hb = form(pb * (q.g0 * ix) - q.gb, zero);
            const Form za = form(q.fa * (-c), q.g0);  // first-order part of F.t by edge a
            add_product3(aa, q.fa, s * c - pa * (0.5 * one));
            aa.v[9] -= q.z;
            add_product(aa, angle, form(q.ga * (-2.0 * c), zero));
            add_product(aa, scaled(za, -2.0 * ix), fpa);
            add_product(aa, ma, scaled(ha, -one));
            add_product3(bb, q.fb, (t + pb * ix) * (-one));
            add_product(bb, mb, scaled(hb, -one));
            add_product3(ab, q.fa * (-one), pb);
            add_product(ab, angle, gb);
            add_product(ab, scaled(za, -ix), fpb);
            add_product3(ab, pa * (-ix), q.fb);
            add_product(ab, scaled(ma, -0.5 * one), hb);
            add_product(ab, scaled(ha, -0.5 * one), mb);
        }
        store(aa, scale_a, &out.aa[i]);
        store(bb, scale_b, &out.bb[i]);
        store(ab, scale_a, scale_b, &out.ab[i]);
    }
    out.bend = sum_lanes(bend_sum);
    out.twist = sum_lanes(twist_sum);
    return smallest[0] > 1e-9 && smallest[1] > 1e-9 && smallest[2] > 1e-9 && smallest[3] > 1e-9;
}

std::size_t padded(int count) {
    return static_cast<std::size_t>((count + 7) / 4 * 4);
}

}  // namespace

void RodShape::resize(int segments) {
    const std::size_t n = padded(segments + 2);
    position.assign(4 * (static_cast<std::size_t>(segments) + 1), 0.0);
    for (auto* array : {&tx, &dy, &length}) array->assign(n, 1.0);
    for (auto* array : {&ty, &tz, &dx, &dz, &inverse, &twist}) array->assign(n, 0.0);
}

std::size_t RodShape::bytes() const {
    return sizeof(double) * (position.capacity() + 9 * tx.capacity());
}

void RodJointTerms::resize(int segments) {
    const std::size_t n = padded(segments + 1);
    gradient_a.assign(4 * n, 0.0);
    gradient_b.assign(4 * n, 0.0);
    aa.resize(n);
    bb.resize(n);
    ab.resize(n);
    energy.assign(n, 0.0);
}

std::size_t RodJointTerms::bytes() const {
    return sizeof(double) * 2 * gradient_a.capacity() + sizeof(Block4) * 3 * aa.capacity();
}

bool joint_terms(const Rod::Tables& tables, const RodShape& shape, const std::vector<double>& stiffness,
                 bool hessian, RodJointTerms& out) {
    const double *bend = stiffness.data(), *twist = tables.twist.data();
    if (tables.curved)
        return hessian ? pass<true, true, false>(tables, shape, bend, twist, out)
                       : pass<true, false, false>(tables, shape, bend, twist, out);
    return hessian ? pass<false, true, false>(tables, shape, bend, twist, out)
                   : pass<false, false, false>(tables, shape, bend, twist, out);
}

bool joint_terms(const Rod::Tables& tables, const RodShape& shape, bool hessian, RodJointTerms& out) {
    return joint_terms(tables, shape, tables.bend, hessian, out);
}

bool unit_joint_terms(const Rod::Tables& tables, const RodShape& shape, RodJointTerms& out) {
    const double *bend = tables.unit.data(), *twist = tables.none.data();
    return tables.curved ? pass<true, false, true>(tables, shape, bend, twist, out)
                         : pass<false, false, true>(tables, shape, bend, twist, out);
}

}  // namespace fulcrum
