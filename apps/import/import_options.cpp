#include "import_options.h"

#include <cmath>

#include "flownav/cli/command_output.h"
#include "flownav/core/version.h"
#include "flownav/io/kitti.h"
#include "flownav/math/units.h"

namespace flownav {
namespace {

constexpr auto help = R"(Makes a rawlog of a data set, of pictures or of a video.

flownav-import kitti-odometry DIR SEQ     --output F.rawlog [--height-m H] [--pitch-deg P] [--roll-deg R] [--yaw-deg Y]
                                          [--forward-m D]
flownav-import kitti-raw DATEDIR DRIVE    --output F.rawlog [--rate HZ] [--height-m H] [--pitch-deg P] [--roll-deg R]
                                          [--yaw-deg Y] [--forward-m D]
flownav-import tum DIR    --camera C.ini  --output F.rawlog [--times-unit UNIT]
flownav-import euroc DIR  --camera C.ini  --output F.rawlog [--times-unit UNIT]
flownav-import images DIR --camera C.ini  --output F.rawlog [--rate HZ | --times T.csv] [--times-unit UNIT]
                                          [--interlaced top_first|bottom_first]
flownav-import video FILE --camera C.ini  --output F.rawlog [--rate HZ] [--interlaced top_first|bottom_first]

  kitti-odometry    DIR/sequences/SEQ/{image_0/*.png, calib.txt, times.txt}; DIR/poses/SEQ.txt becomes ground truth
  kitti-raw         DATEDIR/calib_cam_to_cam.txt, DATEDIR/DRIVE/image_0N/data/*.png; times from timestamps.txt when
                    there, ground truth from oxts when there. DRIVE: the folder, or its part after "drive_", as 0005.
                    Drives _sync and, where the calibration holds K and D, _extract
  tum               DIR/rgb.txt and the images it lists; DIR/groundtruth.txt becomes ground truth
  euroc             DIR/mav0/cam0/{data.csv, data/*.png}; sensor.yaml gives the intrinsics that C.ini leaves open,
                    state_groundtruth_estimate0 becomes ground truth
  images            png, jpg, bmp, pgm, ppm, tif or webp; colour becomes grey, 10 to 16 bits become 8. A folder of the
                    kind tum or euroc is recognised
  video             whatever FFmpeg can read; colour becomes grey, a rotation tag is followed

  --output F.rawlog            the rawlog; it appears when it is complete
  --height-m, --pitch-deg, --roll-deg, --yaw-deg, --forward-m
                               KITTI's camera: over the ground, looking down, tilted to its right, looking to the left,
                               ahead of the rear axle; default: as measured for the day of the drive, else 1.65, 0, 0,
                               0, 1.1
  --camera C.ini               section [camera]: fx_px, fy_px, cx_px, cy_px, height_m, pitch_deg, and what else is
                               known; for interlaced pictures those of the whole frame
  --rate HZ                    images a second: needed for a video without time stamps, instead of the stamps of
                               others; of a folder without times (default 25; KITTI 10), where the numbers in the names
                               count the images
  --times T.csv                times of the images, one a row: the column timestamp, time, stamp ... of the header,
                               such as timestamp_s, time_ms or "timestamp [ns]", else the first with numbers or dates.
                               Rows belong to the images that a column names (filename, file, image ...) or numbers
                               (index, frame ...), else to those in the order of the names. Without --times and --rate,
                               times.txt, log.csv, timestamps.txt, data.csv or rgb.txt in or beside DIR is taken when
                               there, else the names when they are times (1403636579763555584.png)
  --times-unit s|ms|us|ns      unit of these times, or of the names that are times; default: what the header says or
                               what makes the distances of the images usual ones
                               A column gyro_z_degps or gyro_z_radps, > 0 to the left, becomes a CObservationIMU: the
                               mean rate from its row to the next, dated half-way
  --interlaced ORDER           every image is two woven fields; they are written as two images, half a period apart
  --quiet                      no progress and no closing line
  --help, --version            print this text, or the version, and exit

What was recognised, assumed or mended is told in one sentence each, with status 0.

Exit status:
  0  fine
  1  bad usage or configuration, no such data set, or images and times that cannot be matched; nothing was written
  2  part of the recording is missing or could not be read; all the rest was written
  3  output could not be written
)";

struct Subcommand {
    const char* name;
    ImportKind kind;
    std::size_t sources;  ///< number of arguments that name the data
};

constexpr Subcommand subcommands[] = {{"kitti-odometry", ImportKind::KittiOdometry, 2},
                                      {"kitti-raw", ImportKind::KittiRaw, 2},
                                      {"tum", ImportKind::Tum, 1},
                                      {"euroc", ImportKind::Euroc, 1},
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
          times_unit("", "times-unit", "", false, "", "s|ms|us|ns", command),
          interlaced("", "interlaced", "", false, "", "top_first|bottom_first", command),
          height("", "height-m", "", false, "1.65", "H", command),
          pitch("", "pitch-deg", "", false, "0", "P", command),
          roll("", "roll-deg", "", false, "0", "R", command),
          yaw("", "yaw-deg", "", false, "0", "Y", command),
          forward("", "forward-m", "", false, "1.1", "D", command),
          rate("", "rate", "", false, 0.0, "HZ", command),
          quiet("", "quiet", "", command) {}

    using Text = TCLAP::ValueArg<std::string>;
    TCLAP::UnlabeledMultiArg<std::string> words;
    Text output, camera, times, times_unit, interlaced, height, pitch, roll, yaw, forward;
    TCLAP::ValueArg<double> rate;
    TCLAP::SwitchArg quiet;
};

/// Describes missing arguments, or arguments of another subcommand; empty when they are valid.
std::string complaint(Arguments& a, const Subcommand* subcommand) {
    if (subcommand == nullptr)
        return "the first argument has to be kitti-odometry, kitti-raw, tum, euroc, images or video";
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
    const bool listed = kind == ImportKind::Tum || kind == ImportKind::Euroc;
    if (a.times.isSet() && kind != ImportKind::Images) return "--times is for images only";
    if (a.times_unit.isSet() && kind != ImportKind::Images && !listed)
        return "--times-unit is for images, tum and euroc only";
    if (listed && a.rate.isSet()) return name + " has times of its own, no --rate";
    if (a.times.isSet() && a.rate.isSet()) return "give --times or --rate, not both";
    if (a.rate.isSet() && kind == ImportKind::KittiOdometry) return name + " has times of its own, no --rate";
    const bool mount =
        a.height.isSet() || a.pitch.isSet() || a.roll.isSet() || a.yaw.isSet() || a.forward.isSet();
    if (mount && !is_kitti(kind)) return name + " takes the camera's place from --camera C.ini";
    return "";
}

/// Mount of KITTI's camera 0: as measured on the day of the drive, or as the options say.
CameraMount mount_of(Arguments& a, const ImportOptions& options) {
    const bool raw = options.kind == ImportKind::KittiRaw;
    const std::string day = std::filesystem::weakly_canonical(options.source).filename().string();
    CameraMount mount = io::kitti_mount(raw ? day : options.part);
    config::Config config;
    const auto set = [&config](Arguments::Text& option, const char* key, const std::optional<double>& value,
                               double unit, double& member) {
        if (!option.isSet()) return;
        config::set_config_value(config, key, option.getValue());
        member = value.value() * unit;
    };
    const config::CameraConfig& camera = config.camera;
    set(a.height, "camera.height_m", camera.height_m, 1.0, mount.height_m);
    set(a.pitch, "camera.pitch_deg", camera.pitch_deg, degree_rad, mount.pitch_rad);
    set(a.roll, "camera.roll_deg", camera.roll_deg, degree_rad, mount.roll_rad);
    set(a.yaw, "camera.yaw_deg", camera.yaw_deg, degree_rad, mount.yaw_rad);
    set(a.forward, "camera.forward_m", camera.forward_m, 1.0, mount.forward_m);
    return mount;
}

std::optional<io::TimeUnit> times_unit_of(Arguments& a) {
    if (!a.times_unit.isSet()) return std::nullopt;
    const auto unit = io::parse_time_unit(a.times_unit.getValue());
    if (!unit)
        throw config::ConfigError("--times-unit " + a.times_unit.getValue() + ": must be s, ms, us or ns");
    return unit;
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
    options.times_unit = times_unit_of(a);
    options.quiet = a.quiet.getValue();
    if (a.rate.isSet()) options.rate_hz = a.rate.getValue();
    if (a.rate.isSet() && !(a.rate.getValue() > 0.001 && a.rate.getValue() < 1e5)) {
        throw config::ConfigError("--rate " + std::to_string(a.rate.getValue()) +
                                  ": must be 0.001 .. 100000 images a second");
    }
    if (is_kitti(subcommand.kind)) {
        options.mount = mount_of(a, options);
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
