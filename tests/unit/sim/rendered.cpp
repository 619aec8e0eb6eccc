#include "rendered.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <vector>

namespace flownav::sim {
namespace {

Look look_of(const testing::Texture& texture) {
    Look look;
    look.seed = texture.seed;
    look.grey = std::min(150.0 * texture.shade, 200.0);
    switch (texture.surface) {
        case testing::Surface::Plain:
            look.surface = Surface::Plain;
            break;
        case testing::Surface::Carpet:
            look.surface = Surface::Carpet;
            break;
        case testing::Surface::Tiles:
        case testing::Surface::Stoneware:
            look.surface = Surface::Tiles;
            break;
        case testing::Surface::Lino:
        case testing::Surface::Marbled:
            look.surface = Surface::Lino;
            break;
        case testing::Surface::Wall:
        case testing::Surface::Faint:
            look.surface = Surface::Faint;
            break;
        case testing::Surface::Patterned:
            look.surface = Surface::Patterned;
            break;
    }
    return look;
}

}  // namespace

World same_world(const testing::World& world, double until_s) {
    World same;
    same.floor = look_of(world.ground);
    for (const testing::Primitive& p : world.primitives) {
        Solid solid;
        const double height_m = p.z_high_m - p.z_low_m;
        if (p.shape == testing::Shape::Box)
            solid.shape = Box{{2 * p.half_x_m, 2 * p.half_y_m, height_m}};
        else
            solid.shape = Cylinder{p.half_x_m, height_m};
        solid.T_world_solid.translation() << p.centre_m.x(), p.centre_m.y(), (p.z_low_m + p.z_high_m) / 2;
        solid.T_world_solid.rotate(Eigen::AngleAxisd(p.yaw_rad, Eigen::Vector3d::UnitZ()));
        solid.look = look_of(p.texture);
        if (!p.velocity_mps.isZero()) {
            Eigen::Isometry3d later = solid.T_world_solid;
            later.translation().head<2>() += until_s * p.velocity_mps;
            solid.script = {{0.0, solid.T_world_solid}, {until_s, later}};
        }
        same.solids.push_back(solid);
    }
    return same;
}

cv::Mat1b picture_of(const Field& field) {
    cv::Mat1b picture(field.image.height_px, field.image.width_px);
    for (int v = 0; v < picture.rows; ++v)
        std::copy(field.image.row(v), field.image.row(v) + picture.cols, picture[v]);
    return picture;
}

CameraSimParams clean(const CameraModel& camera, int supersampling) {
    CameraSimParams params;
    params.camera = camera;
    params.supersampling = supersampling;
    params.effects.noise_sigma = 0.0;
    return params;
}

cv::Point2d mean_shift(const cv::Mat1b& from, const cv::Mat1b& to) {
    std::vector<cv::Point2f> points;
    std::vector<cv::Point2f> moved;
    std::vector<unsigned char> found;
    std::vector<float> errors;
    cv::goodFeaturesToTrack(from, points, 200, 0.05, 12.0);
    cv::calcOpticalFlowPyrLK(from, to, points, moved, found, errors);
    cv::Point2d sum;
    int count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (found[i] == 0) continue;
        sum += cv::Point2d(moved[i] - points[i]);
        ++count;
    }
    return count > 20 ? sum / count : cv::Point2d(NAN, NAN);
}

}  // namespace flownav::sim
