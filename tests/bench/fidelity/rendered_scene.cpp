#include "rendered_scene.h"

#include <cstring>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "flownav/sim/random.h"

namespace flownav::fidelity {
namespace {

using testing::GreyImage;
using testing::Scene;
namespace fs = std::filesystem;

class Fingerprint {
  public:
    void add(std::uint64_t bits) { state_ = sim::mix(state_, bits); }
    void add(double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        add(bits);
    }
    std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 1;
};

/// Hash of all that the pictures depend on, and of one picture, which depends on the renderer too.
std::uint64_t fingerprint(const Scene& scene) {
    Fingerprint f;
    f.add(scene.options.effects.exposure_s);
    f.add(scene.world.floor.seed);
    f.add(scene.world.waves.highest_m);
    for (int i = 0; i < scene.images(); ++i) {
        const testing::ImageEffects e = testing::image_effects(scene, i);
        for (const double value : {e.gain, e.offset, e.noise_sigma, e.pitch_rad, e.roll_rad, e.height_m})
            f.add(value);
        const Pose2& pose = scene.poses[static_cast<std::size_t>(i)];
        for (const double value : {pose.x_m, pose.y_m, pose.yaw_rad}) f.add(value);
    }
    for (const sim::Solid& solid : scene.world.solids) {
        const testing::Upright u = testing::upright_of(solid);
        const Eigen::Vector3d later_m = pose_at(solid, scene.time_s(scene.images())).translation();
        for (const double value : {u.centre_m.x(), u.centre_m.y(), u.z_low_m, u.z_high_m, u.half_x_m,
                                   u.half_y_m, u.yaw_rad, later_m.x(), later_m.y()})
            f.add(value);
        f.add(solid.look.seed);
    }
    for (const std::uint8_t grey : testing::render_image(scene, scene.images() / 2).pixels)
        f.add(std::uint64_t{grey});
    return f.value();
}

std::optional<GreyImage> read_image(std::istream& in, const CameraModel& camera) {
    GreyImage image(camera.width_px, camera.height_px);
    in.read(reinterpret_cast<char*>(image.pixels.data()),  // NOLINT(*-reinterpret-cast)
            static_cast<std::streamsize>(image.pixels.size()));
    if (!in) return std::nullopt;
    return image;
}

void write_image(std::ostream& out, const GreyImage& image) {
    out.write(reinterpret_cast<const char*>(image.pixels.data()),  // NOLINT(*-reinterpret-cast)
              static_cast<std::streamsize>(image.pixels.size()));
}

Field field_of(const Scene& scene, int i, GreyImage image) {
    const auto owner = std::make_shared<GreyImage>(std::move(image));
    return {testing::scene_start_s + scene.time_s(i), owner->view(), testing::nominal_view(scene, i).camera,
            owner};
}

std::vector<Field> read_fields(const Scene& scene, const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<Field> fields;
    for (int i = 0; in && i < scene.images(); ++i) {
        auto image = read_image(in, testing::nominal_view(scene, i).camera);
        if (!image) return {};
        fields.push_back(field_of(scene, i, std::move(*image)));
    }
    return fields;
}

/// Written beside its place and then moved there, so that no reader sees half of it.
void write_fields(const std::vector<Field>& fields, const fs::path& file) {
    std::ostringstream unique;
    unique << file.string() << '.' << &fields << ".part";
    std::ofstream out(unique.str(), std::ios::binary);
    for (const Field& field : fields)
        write_image(out, *std::static_pointer_cast<const GreyImage>(field.owner));
    out.close();
    if (!out) throw std::runtime_error(file.string() + ": cannot be written; choose another --cache");
    fs::rename(unique.str(), file);
}

}  // namespace

RenderedScene render_scene(const std::string& name, const Scene& scene, const fs::path& cache) {
    RenderedScene rendered{name, scene, {}};
    fs::path file;
    if (!cache.empty()) {
        std::ostringstream number;
        number << std::hex << fingerprint(scene);
        file = cache / (name + '-' + number.str() + ".raw");
        rendered.fields = read_fields(scene, file);
    }
    if (!rendered.fields.empty()) return rendered;
    rendered.fields.resize(static_cast<std::size_t>(scene.images()));
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < scene.images(); ++i)
        rendered.fields[static_cast<std::size_t>(i)] = field_of(scene, i, testing::render_image(scene, i));
    if (!file.empty()) write_fields(rendered.fields, file);
    return rendered;
}

RenderedScene render_scene(const std::string& name, const testing::SceneOptions& options,
                           const fs::path& cache) {
    return render_scene(name, testing::make_scene(options), cache);
}

}  // namespace flownav::fidelity
