#include "import_options.h"

#include <cmath>

#include "flownav/cli/command_output.h"
#include "flownav/core/version.h"
#include "flownav/math/units.h"

namespace flownav {
namespace {

constexpr auto help = R"(Makes a rawlog of a data set, of pictures or of a video.

flownav-import kitti-odometry DIR SEQ     --output F.rawlog [--height-m H] [--pitch-deg P] [--roll-deg R] [--forward-m D]
flownav-import kitti-raw DATEDIR DRIVE    --output F.rawlog [--rate HZ] [--height-m H] [--pitch-deg P] [--roll-deg R] [--forward-m D]
flownav-import images DIR --camera C.ini  --output F.rawlog [--rate HZ | --times T.csv] [--interlaced top_first|bottom_first]
flownav-import video FILE --camera C.ini  --output F.rawlog [--rate HZ] [--interlaced top_first|bottom_first]

  kitti-odometry    DIR/sequences/SEQ/{image_0/*.png, calib.txt, times.txt}; DIR/poses/SEQ.txt becomes ground truth
  kitti-raw         DATEDIR/calib_cam_to_cam.txt, DATEDIR/DRIVE/image_0N/data/*.png; times from timestamps.txt when
                    there, ground truth from oxts when there. DRIVE: the folder, or its part after "drive_", as 0005
  images            png, jpg, bmp, pgm or tif, in the order of their names; colour becomes grey
  video             whatever OpenCV can read; colour becomes grey

  --output F.rawlog            the rawlog; it appears when it is complete
  --height-m, --pitch-deg, --roll-deg, --forward-m
                               KITTI's camera: over the ground (default 1.65), looking down (0), tilted to its right
                               (0), ahead of the rear axle (1.1)
  --camera C.ini               section [camera]: fx_px, fy_px, cx_px, cy_px, height_m, pitch_deg, and what else is
                               known; for interlaced pictures those of the whole frame
  --rate HZ                    images a second, where the images have no times: default 25, KITTI 10, a video its own
  --times T.csv                times in seconds, one a row, in the order of the images: the column timestamp_s,
                               timestamp, time_s or time of the header, or the first column when there is no header.
                               Without --times and --rate, times.txt or log.csv in or beside DIR is taken when there.
                               A column gyro_z_degps or gyro_z_radps, > 0 to the left, becomes a CObservationIMU: the
                               mean rate from its row to the next, dated half-way
  --interlaced ORDER           every image is two woven fields; they are written as two images, half a period apart
  --quiet                      no progress and no closing line
  --help, --version            print this text, or the version, and exit

Exit status:
  0  fine
  1  bad usage or configuration, or no such data set; nothing was written
  2  some images could not be read; all others were written
  3  output could not be written
)";

struct Subcommand {
    const char* name;
    ImportKind kind;
    std::size_t sources;  ///< number of arguments that name the data
};

constexpr Subcommand subcommands[] = {{"kitti-odometry", ImportKind::KittiOdometry, 2},
                                      {"kitti-raw", ImportKind::KittiRaw, 2},
                                      {"images", ImportKind::Images, 1},
                                      {"video", ImportKind::Video, 1}};

const Subcommand* find_subcommand(const std::vector<std::string>& words) {
    for (const Subcommand& candidate : subcommands) {
        if (!words.empty() && words.front() == candidate.name) return &candidate;
    }
    return nullptr;
}

bool is_kitti(ImportKind kind) {
    return kind == ImportKind::KittiOdometry || kind == ImportKind::KittiRaw;
}

/// The arguments as TCLAP options, all of them text: the configuration checks their values.
struct Arguments {
    explicit Arguments(TCLAP::CmdLine& command)
        : words("words", "", false, "", command),
          output("", "output", "", false, "", "F.rawlog", command),
          camera("", "camera", "", false, "", "C.ini", command),
          times("", "times", "", false, "", "T.csv", command),
          interlaced("", "interlaced", "", false, "", "top_first|bottom_first", command),
          height("", "height-m", "", false, "1.65", "H", command),
          pitch("", "pitch-deg", "", false, "0", "P", command),
          roll("", "roll-deg", "", false, "0", "R", command),
          forward("", "forward-m", "", false, "1.1", "D", command),
          rate("", "rate", "", false, 0.0, "HZ", command),
          quiet("", "quiet", "", command) {}

    using Text = TCLAP::ValueArg<std::string>;
    TCLAP::UnlabeledMultiArg<std::string> words;
    Text output, camera, times, interlaced, height, pitch, roll, forward;
    TCLAP::ValueArg<double> rate;
    TCLAP::SwitchArg quiet;
};

/// Describes missing arguments, or arguments of another subcommand; empty when they are valid.
std::string complaint(Arguments& a, const Subcommand* subcommand) {
    if (subcommand == nullptr)
        return "the first argument has to be kitti-odometry, kitti-raw, images or video";
    const std::string name = subcommand->name;
    const ImportKind kind = subcommand->kind;
    if (a.words.getValue().size() != subcommand->sources + 1) {
        return name + " needs " + (is_kitti(kind) ? "a folder and the name of a drive in it" : "one source");
    }
    if (!a.output.isSet()) return name + " needs --output F.rawlog";
    if (!is_kitti(kind) && !a.camera.isSet()) return name + " needs --camera C.ini";
    if (is_kitti(kind) && (a.camera.isSet() || a.interlaced.isSet())) {
        return name + " knows neither --camera nor --interlaced: KITTI brings its calibration";
    }
    if (a.times.isSet() && kind != ImportKind::Images) return "--times is for images only";
    if (a.times.isSet() && a.rate.isSet()) return "give --times or --rate, not both";
    if (a.rate.isSet() && kind == ImportKind::KittiOdometry) return name + " has times of its own, no --rate";
    const bool mount = a.height.isSet() || a.pitch.isSet() || a.roll.isSet() || a.forward.isSet();
    if (mount && !is_kitti(kind)) return name + " takes the camera's place from --camera C.ini";
    return "";
}

CameraMount mount_of(Arguments& a) {
    config::Config config;
    config::set_config_value(config, "camera.height_m", a.height.getValue());
    config::set_config_value(config, "camera.pitch_deg", a.pitch.getValue());
    config::set_config_value(config, "camera.roll_deg", a.roll.getValue());
    config::set_config_value(config, "camera.forward_m", a.forward.getValue());
    CameraMount mount;
    mount.height_m = config.camera.height_m.value();
    mount.pitch_rad = config.camera.pitch_deg.value() * degree_rad;
    mount.roll_rad = config.camera.roll_deg.value() * degree_rad;
    mount.forward_m = config.camera.forward_m.value();
    return mount;
}

config::CameraConfig camera_of(Arguments& a) {
    config::Config config;
    config::load_config_file(config, a.camera.getValue());
    if (a.interlaced.isSet()) config::set_config_value(config, "camera.interlaced", a.interlaced.getValue());
    return config.camera;
}

ImportOptions options_of(Arguments& a, const Subcommand& subcommand) {
    ImportOptions options;
    options.kind = subcommand.kind;
    options.source = a.words.getValue()[1];
    if (subcommand.sources > 1) options.part = a.words.getValue()[2];
    options.output = a.output.getValue();
    options.times = a.times.getValue();
    options.quiet = a.quiet.getValue();
    if (a.rate.isSet()) options.rate_hz = a.rate.getValue();
    if (a.rate.isSet() && !(a.rate.getValue() > 0.001 && a.rate.getValue() < 1e5)) {
        throw config::ConfigError("--rate " + std::to_string(a.rate.getValue()) +
                                  ": must be 0.001 .. 100000 images a second");
    }
    if (is_kitti(subcommand.kind)) {
        options.mount = mount_of(a);
    } else {
        options.camera = camera_of(a);
    }
    return options;
}

}  // namespace

std::optional<ImportOptions> parse_import_options(const std::vector<std::string>& arguments,
                                                  std::ostream& out, std::ostream& error, int& status) {
    TCLAP::CmdLine command("", ' ', version());
    cli::CommandOutput output(command, "flownav-import", help, out, error);
    const auto args = std::make_unique<Arguments>(command);
    status = 0;
    if (!cli::parse_arguments(command, arguments)) {
        status = output.failed() ? 1 : 0;
        return std::nullopt;
    }
    const Subcommand* subcommand = find_subcommand(args->words.getValue());
    const std::string wrong = complaint(*args, subcommand);
    if (wrong.empty()) return options_of(*args, *subcommand);
    output.fail(wrong);
    status = 1;
    return std::nullopt;
}

}  // namespace flownav
