#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flownav/regress/manifest.h"

namespace flownav::regress {

/// The replay program and its identification.
struct ReplayProgram {
    std::filesystem::path file;
    std::string version;  ///< output of --version, such as "flownav-replay 0.1.0"
    std::string sha256;   ///< of the file; identifies changed code of the same version
};

/// One rawlog to replay.
struct Job {
    std::string id;
    std::string title;  ///< for messages; includes the values of a sweep
    std::filesystem::path rawlog;
    std::string sha256;
    std::string ini;  ///< settings that are not flownav's defaults, as the text of an ini
    ReplayProgram program;
    std::string setup;             ///< hash of program and common settings, the same for all jobs of a run
    std::string key;               ///< hash of rawlog, its settings and the setup
    std::filesystem::path output;  ///< root of the run's results
};

/// Data common to all jobs of a run.
struct JobSetup {
    std::filesystem::path root;         ///< base of relative paths in the manifest
    std::string config;                 ///< ini for all, from --config; empty: none
    std::vector<std::string> settings;  ///< section.key=value for all, from --set
    ReplayProgram program;
    std::filesystem::path output;
};

/// Creates the job of one entry: defaults, then --config, then the manifest's settings, then --set. Throws
/// ConfigError that names the entry.
Job make_job(const ManifestEntry& entry, const JobSetup& setup);

/// Creates the job of each entry.
std::vector<Job> make_jobs(const Manifest& manifest, const JobSetup& setup);

/// Finds the replay program: `program` of --program; when it is empty the flownav-replay beside this program,
/// in a build folder beside its folder, or in PATH. Throws UsageError when none is found or its version
/// cannot be read.
ReplayProgram find_replay_program(const std::string& program);

}  // namespace flownav::regress
