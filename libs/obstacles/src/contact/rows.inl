// Included once for each instruction set, inside a namespace of its own.

namespace {

constexpr int chunk = 64;  // places that are computed before they are looked up

template <class T>
inline T smaller(T a, T b) {
    return a < b ? a : b;
}

inline float larger(float a, float b) {
    return a > b ? a : b;
}

/// Grey levels between four pixels at n <= chunk places; NaN outside.
inline void look_up(const Reference& reference, const float* __restrict x, const float* __restrict y, int n,
                    float* __restrict out) {
    const float last_x = static_cast<float>(reference.width - 1);
    const float last_y = static_cast<float>(reference.height - 1);
    const float* const grey = reference.grey;
    const int width = reference.width;
    for (int i = 0; i < n; ++i) {
        const float px = smaller(x[i] > 0.0F ? x[i] : 0.0F, last_x);
        const float py = smaller(y[i] > 0.0F ? y[i] : 0.0F, last_y);
        const int u = smaller(static_cast<int>(px), width - 2);
        const int v = smaller(static_cast<int>(py), reference.height - 2);
        const float dx = px - static_cast<float>(u);
        const float dy = py - static_cast<float>(v);
        const int at = v * width + u;
        const float upper = grey[at] + dx * (grey[at + 1] - grey[at]);
        const float lower = grey[at + width] + dx * (grey[at + width + 1] - grey[at + width]);
        out[i] = upper + dy * (lower - upper);
    }
    for (int i = 0; i < n; ++i) {
        const bool inside = (x[i] >= 0.0F) & (y[i] >= 0.0F) & (x[i] < last_x) & (y[i] < last_y);
        out[i] = inside ? out[i] : __builtin_nanf("");
    }
}

void warp(const Reference& reference, const Places& p, int begin, int end, float* out) {
    float x[chunk];
    float y[chunk];
    for (int from = begin; from < end; from += chunk) {
        const int n = end - from < chunk ? end - from : chunk;
        for (int i = 0; i < n; ++i) {
            const float u = static_cast<float>(from + i);
            const float inverse = 1.0F / (p.z0 + p.z1 * u);
            x[i] = (p.x0 + p.x1 * u) * inverse;
            y[i] = (p.y0 + p.y1 * u) * inverse;
        }
        look_up(reference, x, y, n, out + from);
    }
}

/// The loop of costs(); the compiler has to know that no array overlaps another.
inline void costs_of(const CostRow& r, int begin, int end, const float* __restrict above,
                     const float* __restrict now, const float* __restrict below,
                     const float* __restrict before, const float* __restrict offset, float* __restrict cost,
                     float* __restrict steepness2, Packed* __restrict counts, Packed* __restrict evidence) {
    const Places p = r.places;
    const float v = r.v, w0 = r.w0, w1 = r.w1, bx = r.bx, by = r.by, bz = r.bz;
    const float gain = r.gain, noise2 = r.noise * r.noise;
    const float edge2 = edge_per_noise * edge_per_noise * noise2;
    const float gradient2_min = gradient_per_noise * gradient_per_noise * noise2;
    const float parallax_min = parallax_per_noise * r.noise;
    for (int u = begin; u < end; ++u) {
        const float at = static_cast<float>(u);
        const float inverse = 1.0F / (p.z0 + p.z1 * at);
        const float x = (p.x0 + p.x1 * at) * inverse;
        const float y = (p.y0 + p.y1 * at) * inverse;
        const float w = 0.25F * (w0 + w1 * at) * inverse;
        const float dx = now[u + 1] - now[u - 1];
        const float dy = below[u] - above[u];
        const float gx = 0.125F * (above[u + 1] - above[u - 1] + below[u + 1] - below[u - 1]) + 0.25F * dx;
        const float gy = 0.125F * (below[u - 1] - above[u - 1] + below[u + 1] - above[u + 1]) + 0.25F * dy;
        const float g2 = gx * gx + gy * gy;
        const float steep2 = 0.25F * (dx * dx + dy * dy);
        const float flow2 = (x - at) * (x - at) + (y - v) * (y - v);
        const float t2 =
            position_error_px * position_error_px + position_error_per_flow * position_error_per_flow * flow2;
        // |gradient . d|, d: the displacement that a quarter more inverse depth causes.
        const float parallax = __builtin_fabsf((gx * (bx - x * bz) + gy * (by - y * bz)) * w);
        const float e = now[u] - gain * before[u] - offset[u];
        const float c = smaller(e * e / (2.0F * (noise2 + t2 * steep2)), cost_max);
        const float displacement2 = larger(displacement2_min, displacement2_per_tolerance2 * t2);
        const Packed seen = g2 == g2 ? seen_one : 0U;
        const Packed compared = (e == e) & (g2 == g2) ? compared_one : 0U;
        const Packed misfit = c > misfit_cost ? misfit_one : 0U;
        const Packed fits = c < floor_cost ? floor_one : 0U;
        const Packed contradicts = c > misfit_cost ? not_floor_one : 0U;
        const int informative =
            (parallax > parallax_min) & (g2 > gradient2_min) & (parallax * parallax > displacement2 * g2);
        cost[u] = c;
        steepness2[u] = steep2;
        counts[u] = seen | (g2 > edge2 ? edge_one : 0U) | compared | (compared != 0 ? misfit : 0U);
        evidence[u] = compared != 0 ? (informative != 0 ? fits | contradicts : 0U) : 0U;
    }
}

void costs(const CostRow& r, int begin, int end) {
    costs_of(r, begin, end, r.above, r.now, r.below, r.before, r.offset, r.cost, r.steepness2, r.counts,
             r.evidence);
}

inline void preferences_of(const CostRow& r, int begin, int end, const float* __restrict now,
                           const float* __restrict before, const float* __restrict nearer,
                           const float* __restrict offset, const float* __restrict cost,
                           const float* __restrict steepness2, float* __restrict preference) {
    const float gain = r.gain, noise2 = r.noise * r.noise;
    const float t2 = position_error_px * position_error_px;
    for (int u = begin; u < end; ++u) {
        const float e = now[u] - gain * nearer[u] - offset[u];
        const float c = smaller(e * e / (2.0F * (noise2 + t2 * steepness2[u])), cost_max);
        const int known = (nearer[u] == nearer[u]) & (before[u] == before[u]);
        preference[u] = known != 0 ? c - cost[u] : 0.0F;
    }
}

void preferences(const CostRow& r, int begin, int end) {
    preferences_of(r, begin, end, r.now, r.before, r.before_nearer, r.offset, r.cost, r.steepness2,
                   r.preference);
}

inline void edges_of(float noise, int begin, int end, const float* __restrict above,
                     const float* __restrict now, const float* __restrict below, Packed* __restrict counts) {
    const float edge2 = plain_edge2 * edge_per_noise * edge_per_noise * noise * noise;
    for (int u = begin; u < end; ++u) {
        const float gx = 0.5F * (now[u + 1] - now[u - 1]);
        const float gy = 0.5F * (below[u] - above[u]);
        const float g2 = gx * gx + gy * gy;
        counts[u] = (g2 == g2 ? seen_one : 0U) | (g2 > edge2 ? edge_one : 0U);
    }
}

void edges(const CostRow& r, int begin, int end) {
    edges_of(r.noise, begin, end, r.above, r.now, r.below, r.counts);
}

inline void differences_of(float gain, float limit, int begin, int end, const float* __restrict now,
                           const float* __restrict before, float* __restrict sums,
                           float* __restrict numbers) {
    for (int u = begin; u < end; ++u) {
        const float e = now[u] - gain * before[u];
        const float clipped = smaller(larger(e, -limit), limit);
        sums[u] += e == e ? clipped : 0.0F;
        numbers[u] += e == e ? 1.0F : 0.0F;
    }
}

void differences(const CostRow& r, float limit, int begin, int end, float* sums, float* numbers) {
    differences_of(r.gain, limit, begin, end, r.now, r.before, sums, numbers);
}

void vote(const Reference& reference, const Vote& p, const float* inverse, int count, float* sums) {
    float x[chunk];
    float y[chunk];
    float grey[chunk];
    float given_of[chunk];
    for (int from = 0; from < count; from += chunk) {
        const int n = count - from < chunk ? count - from : chunk;
        for (int i = 0; i < n; ++i) {
            const float w = inverse[from + i];
            const float scale = 1.0F / (p.z + p.bz * w);
            x[i] = (p.x + p.bx * w) * scale;
            y[i] = (p.y + p.by * w) * scale;
        }
        look_up(reference, x, y, n, grey);
        int fits = 0;
        for (int i = 0; i < n; ++i) {
            const float e = p.grey - grey[i];
            const float du = x[i] - p.u;
            const float dv = y[i] - p.v;
            const float t2 = position_error_px * position_error_px +
                             position_error_per_flow * position_error_per_flow * (du * du + dv * dv);
            const float cost = e * e / (2.0F * (p.noise2 + t2 * p.steepness2));
            const float given = cost < fit_cost ? p.cost - cost : -against;
            fits += cost < fit_cost ? 1 : 0;
            given_of[i] = grey[i] == grey[i] ? given : 0.0F;
        }
        // A pixel that fits contacts everywhere tells little about any.
        const float misfits = 1.0F - static_cast<float>(fits) / static_cast<float>(n);
        const float weight = p.weight * larger(least_telling, misfits);
        for (int i = 0; i < n; ++i) sums[from + i] += weight * given_of[i];
    }
}

}  // namespace

extern const Functions table;
const Functions table = {warp, costs, preferences, edges, differences, vote};
