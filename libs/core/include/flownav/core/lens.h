#pragma once
#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace flownav {

/// Coefficients of a lens; their meaning is the lens's own.
using LensCoefficients = std::array<double, 5>;

/// A model of lens distortion on normalised coordinates (x right, y down, focal length 1). Stateless: several
/// threads may use one lens at the same time.
class Lens {
  public:
    Lens() = default;
    virtual ~Lens() = default;
    Lens(const Lens&) = delete;
    Lens& operator=(const Lens&) = delete;

    /// Name in the configuration, of the characters a-z, 0-9 and _.
    virtual std::string name() const = 0;

    /// True when distort() returns every point unchanged, as a pinhole camera does.
    virtual bool is_ideal(const LensCoefficients& k) const = 0;

    /// Normalised coordinates at which the lens shows an ideal point.
    virtual Eigen::Vector2d distort(const Eigen::Vector2d& ideal, const LensCoefficients& k) const = 0;

    /// Inverse of distort(). Unless overridden: Newton steps from `distorted` with a numeric Jacobian.
    virtual Eigen::Vector2d undistort(const Eigen::Vector2d& distorted, const LensCoefficients& k) const;
};

/// The built-in lens "brown_conrady": k1 k2 p1 p2 k3, OpenCV's order.
const Lens& brown_conrady();

/// Adds a lens, which then lives to the end of the program. Throws std::invalid_argument: no lens, or a name
/// that is taken or cannot be used.
void register_lens(std::shared_ptr<const Lens> lens);

/// Returns a lens by its name. Throws std::invalid_argument, which lists the known names.
const Lens& find_lens(const std::string& name);

/// Names of all lenses, in the order of their registration.
std::vector<std::string> lens_names();

}  // namespace flownav
