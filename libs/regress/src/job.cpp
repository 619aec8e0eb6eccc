#include "flownav/regress/job.h"

#include "flownav/cli/configuration.h"
#include "flownav/config/config.h"
#include "flownav/regress/sha256.h"

namespace flownav::regress {

namespace {

config::Config config_of(const ManifestEntry& entry, const JobSetup& setup) {
    config::Config config = cli::configuration(setup.config, {});
    if (!entry.config.empty()) config::load_config_file(config, setup.root / entry.config);
    cli::apply_settings(config, entry.settings);
    cli::apply_settings(config, setup.settings);
    return config;
}

}  // namespace

Job make_job(const ManifestEntry& entry, const JobSetup& setup) try {
    Job job;
    job.id = job.title = entry.id;
    job.rawlog = setup.root / entry.rawlog;
    job.sha256 = entry.sha256;
    job.ini = config::dump_changes(config_of(entry, setup));
    job.program = setup.program;
    job.output = setup.output;
    job.setup = sha256_of_text(setup.program.version + '\n' + setup.program.sha256 + '\n' +
                               config::dump_changes(cli::configuration(setup.config, setup.settings)));
    job.key = sha256_of_text(job.sha256 + '\n' + job.setup + '\n' + job.ini);
    return job;
} catch (const config::ConfigError& error) {
    throw config::ConfigError(entry.id + ": " + error.what());
}

std::vector<Job> make_jobs(const Manifest& manifest, const JobSetup& setup) {
    std::vector<Job> jobs;
    jobs.reserve(manifest.size());
    for (const ManifestEntry& entry : manifest) jobs.push_back(make_job(entry, setup));
    return jobs;
}

}  // namespace flownav::regress
