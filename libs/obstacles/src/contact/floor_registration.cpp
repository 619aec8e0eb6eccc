#include "flownav/obstacles/floor_registration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "bilinear.h"
#include "flownav/math/order_statistic.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector3d;
using Parameters = Eigen::Matrix<double, 7, 1>;
using Pixel = RegistrationScratch::Pixel;

constexpr int tile_px = 12;  // one pixel a tile: the one with the strongest gradient
constexpr std::size_t pixels_min = 24;
constexpr double gradient_min = 0.6;  // grey levels a pixel at noise 0.82
constexpr double tukey_cut = 3.0;
constexpr double errors_max = 5.0;  // standard errors by which a correction may differ from none
constexpr double distance_max_m = 8.0;

Parameters vector_of(const PairMotion& m) {
    Parameters q;
    q << m.forward_m, m.right_m, m.omega_rad, m.pitch_rad, m.roll_rad, m.slope, m.cross_slope;
    return q;
}

PairMotion motion_of(const Parameters& q) {
    return {q[0], q[1], q[2], q[3], q[4], q[5], q[6]};
}

/// The strongest edge of every tile below the horizon, in every second row.
void choose_pixels(const LevelImage& image, double noise, std::vector<Pixel>& out) {
    out.clear();
    const double first = image.camera.row_of(image.camera.height_m / distance_max_m);
    const int top = static_cast<int>(std::clamp(std::ceil(first), 2.0, std::max(2.0, 1.0 * image.height)));
    const double least = std::max(gradient_min, noise);
    for (int v0 = top; v0 + tile_px < image.height - 1; v0 += tile_px) {
        for (int u0 = 2; u0 + tile_px < image.width - 1; u0 += tile_px) {
            Pixel best{};
            float best2 = static_cast<float>(least * least);
            for (int v = v0; v < v0 + tile_px; v += 2) {
                const float* const row = image.row(v);
                for (int u = u0; u < u0 + tile_px; ++u) {
                    const float gx = 0.5F * (row[u + 1] - row[u - 1]);
                    const float gy = 0.5F * (row[u + image.width] - row[u - image.width]);
                    const float g2 = gx * gx + gy * gy;
                    if (!(g2 > best2)) continue;
                    best2 = g2;
                    best = {static_cast<float>(u), static_cast<float>(v), row[u], gx, gy};
                }
            }
            if (best.v > 0.0F) out.push_back(best);
        }
    }
}

/// Change of the pixel's place in the reference with the parameters, as change of the residual.
std::array<float, 7> jacobian(const Pixel& p, const LevelCamera& c, const Parameters& q) {
    const double x = (p.u - c.cx_px) / c.fx_px;
    const double y = (p.v - c.cy_px) / c.fy_px;
    const Vector3d d(x, c.a * y + c.b, c.a - c.b * y);
    const double w = (q[6] * d.x() + d.y() + q[5] * d.z()) / c.height_m;
    const Vector3d t(q[1], 0.0, q[0]);
    const Vector3d r = d + w * t;
    const double Z = c.b * r.y() + c.a * r.z();
    const double X = r.x();
    const double Y = c.a * r.y() - c.b * r.z();
    // Gradient of the reference's grey level with respect to r; the image of the reference is as steep as the
    // newer one.
    const double gx = p.gx * c.fx_px / Z;
    const double gy = p.gy * c.fy_px / Z;
    const double along = -(gx * X + gy * Y) / Z;
    const Vector3d g(gx, c.a * gy + c.b * along, -c.b * gy + c.a * along);
    const auto value = [&](const Vector3d& change) { return static_cast<float>(g.dot(change)); };
    return {value({0.0, 0.0, w}),         value({w, 0.0, 0.0}),        value({-r.z(), 0.0, r.x()}),
            value({0.0, -r.z(), r.y()}),  value({r.y(), -r.x(), 0.0}), value(t * d.z() / c.height_m),
            value(t * d.x() / c.height_m)};
}

/// Residuals of the pixels whose place in the reference is known; the others get NaN.
void residuals(const LevelImage& reference, const std::vector<Pixel>& pixels, const Eigen::Matrix3d& H,
               std::vector<double>& out) {
    out.clear();
    for (const Pixel& p : pixels) {
        const Vector3d at = H * Vector3d(p.u, p.v, 1.0);
        const auto x = static_cast<float>(at.x() / at.z());
        const auto y = static_cast<float>(at.y() / at.z());
        out.push_back(at.z() > 0.0 && can_sample(reference, x, y) ? p.grey - sample(reference, x, y) : NAN);
    }
}

double median_of(const std::vector<double>& values, std::vector<double>& sorted) {
    sorted.clear();
    for (const double v : values)
        if (!std::isnan(v)) sorted.push_back(v);
    return sorted.size() < pixels_min ? NAN : nth_smallest(sorted, sorted.size() / 2);
}

/// One step of Gauss-Newton with the tolerance of position `blur_px`; false when too few pixels count.
bool improve(const LevelImage& reference, const LevelImage& newer, const Parameters& q0,
             const Parameters& weight, double noise, double blur_px, Parameters& q, RegistrationScratch& s) {
    residuals(reference, s.pixels, floor_homography(pair_warp(reference.camera, newer.camera, motion_of(q))),
              s.residuals);
    const double middle = median_of(s.residuals, s.sorted);
    if (std::isnan(middle)) return false;
    Eigen::Matrix<double, 7, 7> N = weight.asDiagonal();
    Parameters b = weight.cwiseProduct(q0 - q);
    for (std::size_t i = 0; i < s.pixels.size(); ++i) {
        if (std::isnan(s.residuals[i])) continue;
        const Pixel& p = s.pixels[i];
        const double e = s.residuals[i] - middle;
        const double g2 = p.gx * p.gx + p.gy * p.gy;
        const double variance = noise * noise + blur_px * blur_px * g2;
        const double r2 = e * e / (variance * tukey_cut * tukey_cut);
        if (r2 >= 1.0) continue;
        const double w = (1.0 - r2) * (1.0 - r2) / variance;
        const std::array<float, 7>& j = s.jacobians[i];
        for (int k = 0; k < 7; ++k) {
            const double wj = w * j[static_cast<std::size_t>(k)];
            b[k] += wj * e;
            for (int l = 0; l <= k; ++l) N(k, l) += wj * j[static_cast<std::size_t>(l)];
        }
    }
    q += N.selfadjointView<Eigen::Lower>().ldlt().solve(b);
    return true;
}

}  // namespace

void reserve(RegistrationScratch& scratch, std::size_t pixels) {
    const std::size_t tiles = pixels / (tile_px * tile_px) + 1;
    scratch.pixels.reserve(tiles);
    scratch.residuals.reserve(tiles);
    scratch.sorted.reserve(tiles);
    scratch.jacobians.reserve(tiles);
}

void choose_floor_pixels(const LevelImage& newer, double noise, RegistrationScratch& scratch) {
    choose_pixels(newer, noise, scratch.pixels);
}

PairMotion register_floor(const LevelImage& reference, const LevelImage& newer, const PairMotion& measured,
                          const PairPrior& prior, double noise, RegistrationScratch& scratch) {
    const Parameters q0 = vector_of(measured);
    scratch.jacobians.clear();
    for (const Pixel& p : scratch.pixels) scratch.jacobians.push_back(jacobian(p, newer.camera, q0));
    Parameters sigma;
    sigma << prior.forward_m, prior.right_m, prior.omega_rad, prior.pitch_rad, prior.roll_rad, prior.slope,
        prior.cross_slope;
    const Parameters weight = sigma.array().square().inverse();
    Parameters q = q0;
    for (const double blur_px : {1.0, 0.5, 0.25, 0.25}) {
        if (!improve(reference, newer, q0, weight, noise, blur_px, q, scratch)) return measured;
    }
    const bool is_near = ((q - q0).array().abs() < errors_max * sigma.array()).all();
    return is_near ? motion_of(q) : measured;
}

}  // namespace flownav::obstacles
