// Writes the recordings of the replay benchmark: the sample in several storage formats, and a long drive of
// ROUNDS times the sample. Usage: flownav-bench-recordings FOLDER [ROUNDS].
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "flownav/io/rawlog_reader.h"
#include "sample.h"

namespace flownav::bench {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation;
using mrpt::obs::CObservationImage;
using Observations = std::vector<CObservation::Ptr>;

Observations read_all(const fs::path& rawlog) {
    io::RawlogReader reader(rawlog);
    Observations all;
    while (const auto observation = reader.next()) all.push_back(observation);
    return all;
}

void write_all(const Observations& all, mrpt::io::CStream& stream) {
    auto archive = mrpt::serialization::archiveFrom(stream);
    for (const auto& observation : all) archive << *observation;
}

void write_gz(const Observations& all, const fs::path& file, int level) {
    mrpt::io::CFileGZOutputStream stream(file.string(), mrpt::io::OpenMode::TRUNCATE, level);
    write_all(all, stream);
}

void write_plain(const Observations& all, const fs::path& file) {
    mrpt::io::CFileOutputStream stream(file.string());
    write_all(all, stream);
}

/// Stores the images as separate files below NAME_Images, where MRPT looks for them.
Observations with_files(const Observations& all, const fs::path& rawlog, const std::string& extension) {
    const fs::path folder = rawlog.parent_path() / (rawlog.stem().string() + "_Images");
    fs::create_directories(folder);
    Observations result;
    for (const auto& observation : all) {
        result.emplace_back(std::dynamic_pointer_cast<CObservation>(observation->duplicateGetSmartPtr()));
        const auto picture = std::dynamic_pointer_cast<CObservationImage>(result.back());
        if (!picture) continue;
        const std::string name = "image" + std::to_string(result.size()) + extension;
        const auto& pixels = picture->image.asCvMatRef();
        if (!cv::imwrite((folder / name).string(), pixels)) throw std::runtime_error("cannot write " + name);
        picture->image.setExternalStorage(name);
    }
    return result;
}

/// Repeats the drive `rounds` times, with a pause of a second in between.
void write_long(Observations all, const fs::path& file, int rounds) {
    mrpt::io::CFileOutputStream stream(file.string());
    const auto round = all.back()->timestamp - all.front()->timestamp + std::chrono::seconds(1);
    for (int i = 0; i < rounds; ++i) {
        write_all(all, stream);
        for (const auto& observation : all) observation->timestamp += round;
    }
}

void write_recordings(const fs::path& folder, int rounds) {
    fs::create_directories(folder);
    const Observations all = read_all(sample_rawlog());
    for (const int level : {1, 6, 9})
        write_gz(all, folder / ("gz" + std::to_string(level) + ".rawlog"), level);
    write_plain(all, folder / "plain.rawlog");
    write_plain(with_files(all, folder / "png.rawlog", ".png"), folder / "png.rawlog");
    const Observations jpeg = with_files(all, folder / "jpeg.rawlog", ".jpg");
    write_plain(jpeg, folder / "jpeg.rawlog");
    fs::remove_all(folder / "long_Images");
    fs::copy(folder / "jpeg_Images", folder / "long_Images",
             fs::copy_options::recursive | fs::copy_options::create_hard_links);
    write_long(jpeg, folder / "long.rawlog", rounds);
}

}  // namespace
}  // namespace flownav::bench

int main(int argc, char** argv) {
    try {
        if (argc != 2 && argc != 3)
            throw std::runtime_error("usage: flownav-bench-recordings FOLDER [ROUNDS]");
        flownav::bench::write_recordings(argv[1], argc == 3 ? std::stoi(argv[2]) : 10);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
