#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flownav/regress/manifest.h"

namespace flownav::regress {

/// The program that replays, and how it is told apart from others.
struct ReplayProgram {
    std::filesystem::path file;
    std::string version;  ///< what it says of itself, such as "flownav-replay 0.1.0"
    std::string sha256;   ///< of the file: code that changed is another program, whatever it says
};

/// One rawlog to be replayed.
struct Job {
    std::string id;
    std::string title;  ///< for people; of a sweep with the values
    std::filesystem::path rawlog;
    std::string sha256;
    std::string ini;  ///< the settings that are not flownav's defaults, as the text of an ini
    ReplayProgram program;
    std::string setup;  ///< the same for all jobs of a run: changes with program and common settings
    std::string key;    ///< changes with rawlog, its settings and the setup
    std::filesystem::path output;  ///< root of the run's results
};

/// What every job of a run shares.
struct JobSetup {
    std::filesystem::path root;         ///< what relative paths of the manifest start from
    std::string config;                 ///< ini for all, from --config; empty: none
    std::vector<std::string> settings;  ///< section.key=value for all, from --set
    ReplayProgram program;
    std::filesystem::path output;
};

/// The job of one entry: defaults, then --config, then what the manifest says, then --set. Throws ConfigError
/// that names the entry.
Job make_job(const ManifestEntry& entry, const JobSetup& setup);

/// make_job of each entry.
std::vector<Job> make_jobs(const Manifest& manifest, const JobSetup& setup);

/// `program` of --program; when it is empty the flownav-replay beside this program, in a build folder beside
/// its folder, or in PATH. Throws UsageError when there is none, or it cannot tell its version.
ReplayProgram find_replay_program(const std::string& program);

}  // namespace flownav::regress
