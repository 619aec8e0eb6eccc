#include "flownav/sim/camera_simulator.h"

#include <mrpt/opengl/CFBORender.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "depth_rays.h"
#include "egl_context.h"
#include "flownav/sim/ground.h"
#include "image_effects.h"
#include "lens.h"
#include "world_scene.h"

namespace flownav::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using mrpt::opengl::CCamera;
using mrpt::opengl::CFBORender;

constexpr float near_m = 0.03F;
constexpr float far_m = 400.0F;
constexpr int columns_step = 4;

void check(const CameraSimParams& params) {
    const CameraModel& camera = params.camera;
    const auto fail = [](const std::string& what) {
        throw std::invalid_argument("simulated camera: " + what);
    };
    if (camera.width_px < 16 || camera.height_px < 16 || camera.width_px > 4096 || camera.height_px > 4096)
        fail("width and height must be 16..4096 px");
    if (!(camera.fx_px > 0.04 * camera.width_px) || !(camera.fy_px > 0.04 * camera.height_px))
        fail("camera.fx_px and fy_px must be > 0.04 of the image's width and height: are these pixels?");
    if (!(camera.mount.height_m > 0.0)) fail("height must be > 0 m");
    if (params.supersampling < 1 || params.supersampling > 4) fail("supersampling must be 1..4");
    const CameraEffects& e = params.effects;
    if (!(e.noise_sigma >= 0.0) || !(e.blur_px >= 0.0)) fail("noise and blur must be >= 0");
}

ViewPyramid pyramid(const Pinhole& pinhole, const Isometry3d& T_world_camera) {
    ViewPyramid view;
    view.eye_m = T_world_camera.translation();
    const double left = -pinhole.cx_px / pinhole.fx_px;
    const double right = (pinhole.size_px.width - pinhole.cx_px) / pinhole.fx_px;
    const double top = -pinhole.cy_px / pinhole.fy_px;
    const double bottom = (pinhole.size_px.height - pinhole.cy_px) / pinhole.fy_px;
    view.inward = {Vector3d(1, 0, -left), Vector3d(-1, 0, right), Vector3d(0, 1, -top),
                   Vector3d(0, -1, bottom)};
    for (Vector3d& inward : view.inward) inward = T_world_camera.linear() * inward.normalized();
    return view;
}

mrpt::poses::CPose3D to_mrpt(const Isometry3d& pose) {
    mrpt::math::CMatrixDouble44 matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) matrix(row, column) = pose.matrix()(row, column);
    return mrpt::poses::CPose3D(matrix);
}

CCamera to_mrpt(const Pinhole& pinhole, cv::Size size, const Isometry3d& T_world_camera) {
    mrpt::img::TCamera intrinsics;
    intrinsics.ncols = static_cast<std::uint32_t>(size.width);
    intrinsics.nrows = static_cast<std::uint32_t>(size.height);
    intrinsics.setIntrinsicParamsFromValues(pinhole.fx_px, pinhole.fy_px, pinhole.cx_px, pinhole.cy_px);
    CCamera camera;
    camera.set6DOFMode(true);
    camera.setProjectiveFromPinhole(intrinsics);
    camera.setPose(to_mrpt(T_world_camera));
    return camera;
}

/// The next width at which three bytes a pixel fill whole words of four bytes. OpenGL pads the rows that it
/// reads back to such words, while MRPT provides rows without gaps: of another width they would be written
/// beyond the end of the picture.
int readable_width(int width_px) {
    return (width_px + columns_step - 1) / columns_step * columns_step;
}

}  // namespace

CameraModel image_camera(const CameraSimParams& params, int image) {
    if (!params.interlaced) return params.camera;
    return field_camera(params.camera, image % 2 == 0 ? Parity::Top : Parity::Bottom);
}

struct CameraSimulator::Impl {
    World world;
    CameraSimParams params;
    std::array<Lens, 2> lenses;  ///< of the two parities
    cv::Size size;               ///< of the renderer: holds both
    EglContext context;          ///< outlives what uses OpenGL
    std::shared_ptr<WorldScene> meshes;
    mrpt::opengl::COpenGLScene scene;
    std::unique_ptr<CFBORender> renderer;
    ImageEffects effects;
    mrpt::img::CImage colours;  ///< buffers that are used again
    cv::Mat1b grey;
    cv::Mat1b bent;

    Impl(const World& its_world, const CameraSimParams& its_params)
        : world(its_world), params(its_params), effects(its_params.effects) {
        for (const int parity : {0, 1}) {
            lenses[parity] = make_lens(image_camera(params, parity), params.supersampling);
            const cv::Size needed = lenses[parity].pinhole.size_px;
            size = {std::max(size.width, needed.width), std::max(size.height, needed.height)};
        }
        size.width = readable_width(size.width);
        meshes = std::make_shared<WorldScene>(world);
        scene.insert(meshes);
        const auto sky = static_cast<float>(world.sky_grey / 255.0);
        scene.getViewport()->setCustomBackgroundColor({sky, sky, sky});
        scene.getViewport()->setViewportClipDistances(near_m, far_m);
        CFBORender::Parameters parameters(static_cast<unsigned>(size.width),
                                          static_cast<unsigned>(size.height));
        parameters.create_EGL_context = false;
        renderer = std::make_unique<CFBORender>(parameters);
    }

    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() { context.make_current(); }

    /// Pose of the camera on a robot that stands on the ground of the world.
    Isometry3d true_pose(const CameraMount& mount, const Pose2& T_world_robot) const {
        return camera_pose(mount, T_world_robot, ride_on_ground(world, T_world_robot));
    }

    /// Picture of `camera` on `mount`: the pinhole picture, bent by the lens and averaged over the
    /// supersampling.
    cv::Mat1b render(const Lens& lens, const CameraModel& camera, const Pose2& T_world_robot,
                     const CameraMount& mount, double time_s) {
        context.make_current();
        const Isometry3d T_world_camera = true_pose(mount, T_world_robot);
        meshes->look(pyramid(lens.pinhole, T_world_camera),
                     FloorLight(world, T_world_robot, time_s, T_world_camera.translation()), time_s);
        renderer->setCamera(scene, to_mrpt(lens.pinhole, size, T_world_camera));
        renderer->render_RGB(scene, colours);
        cv::extractChannel(colours.asCvMatRef(), grey, 0);
        cv::Mat1b fine = grey(cv::Rect({0, 0}, lens.pinhole.size_px));
        if (!lens.map_x.empty()) {
            cv::remap(fine, bent, lens.map_x, lens.map_y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
            fine = bent;
        }
        cv::Mat1b picture(camera.height_px, camera.width_px);
        cv::resize(fine, picture, picture.size(), 0, 0, cv::INTER_AREA);
        return picture;
    }

    /// Mount of the camera with the image's vibration.
    CameraMount shaken(CameraMount mount, int image) const {
        const Tilt tilt = tilt_of_image(params.effects, image);
        mount.pitch_rad += tilt.pitch_rad;
        mount.roll_rad += tilt.roll_rad;
        return mount;
    }
};

CameraSimulator::CameraSimulator(const World& world, const CameraSimParams& params) {
    check(params);
    if (world.waves.highest_m != 0.0)
        throw std::invalid_argument("simulated camera: draws no waves of the floor");
    impl_ = std::make_unique<Impl>(world, params);
}

CameraSimulator::~CameraSimulator() = default;
CameraSimulator::CameraSimulator(CameraSimulator&&) noexcept = default;
CameraSimulator& CameraSimulator::operator=(CameraSimulator&&) noexcept = default;

Field CameraSimulator::take(int image, const Pose2& T_world_robot, double time_s) {
    if (image < 0) throw std::invalid_argument("simulated camera: image numbers must be >= 0");
    const CameraModel camera = image_camera(impl_->params, image);
    const auto picture = std::make_shared<cv::Mat1b>(impl_->render(
        impl_->lenses[image % 2], camera, T_world_robot, impl_->shaken(camera.mount, image), time_s));
    impl_->effects.apply(*picture, image);
    Field field;
    field.timestamp_s = sim_start_s + time_s;
    field.image = {picture->data, picture->cols, picture->rows,
                   static_cast<std::ptrdiff_t>(picture->step[0])};
    field.camera = camera;
    field.owner = picture;
    return field;
}

cv::Mat1b CameraSimulator::render(const Pose2& T_world_robot, double time_s) {
    const CameraModel camera = image_camera(impl_->params, 0);
    return impl_->render(impl_->lenses[0], camera, T_world_robot, camera.mount, time_s);
}

cv::Mat1f CameraSimulator::depth_m(const Pose2& T_world_robot, double time_s) {
    const CameraModel camera = image_camera(impl_->params, 0);
    return exact_depth(impl_->world, camera, impl_->true_pose(camera.mount, T_world_robot), time_s);
}

}  // namespace flownav::sim
