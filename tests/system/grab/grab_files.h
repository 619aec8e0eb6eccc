#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "flownav/io/rawlog_reader.h"

namespace flownav::testing {

/// Label and time stamp in units of 100 ns.
using Sighting = std::pair<std::string, std::int64_t>;

/// The observations of a recording in their order, and the way that reading ended.
struct Contents {
    std::vector<Sighting> sightings;
    io::ReadEnd end;
};

Contents contents_of(const std::filesystem::path& rawlog);

/// Reads the observations noted by the test sensors.
std::vector<Sighting> journal_of(const std::filesystem::path& journal);

/// F.rawlog, F_001.rawlog, ... as far as they exist.
std::vector<std::filesystem::path> parts_of(const std::filesystem::path& rawlog);

/// Elements of `all` that are not in `some`.
std::vector<Sighting> missing(std::vector<Sighting> all, std::vector<Sighting> some);

void write_text(const std::filesystem::path& file, const std::string& text);

/// Ini with two test sensors, one fast and one with images, that note their observations in `journal`.
std::string two_sensors(const std::filesystem::path& journal);

/// Creates an empty folder for the running test.
std::filesystem::path grab_folder();

}  // namespace flownav::testing
