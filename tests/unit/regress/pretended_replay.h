#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app_runs.h"
#include "flownav/regress/sha256.h"
#include "regress_app.h"

namespace flownav::testing {

/// A folder with a fake flownav-replay and "rawlogs" that select its behaviour: fine, damaged, crash, hang,
/// unwritable. Each replay is noted in `calls`; a hanging one opens the FIFO `started` first.
class PretendedReplay : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = folder_of_test("regress");
        write_program("9.1");
        for (const char* name : {"one", "two", "three"}) add(name, "fine");
    }

    void write_program(const std::string& version_text) const {
        std::ofstream(program()) << "#!/bin/sh\n[ \"$1\" = --version ] && echo flownav-replay "
                                 << version_text << " && exit\n"
                                 << script;
        std::filesystem::permissions(program(), std::filesystem::perms::owner_all);
    }

    /// Adds a line to the manifest.
    void add(const std::string& id, const std::string& what) {
        const std::string text = what + " " + id;
        std::ofstream(folder_ / (id + ".rawlog")) << text;
        add_line(id + ' ' + id + ".rawlog " + regress::sha256_of_text(text));
    }
    void add_line(const std::string& line) {
        lines_ += line + '\n';
        std::ofstream(folder_ / "manifest") << lines_;
    }

    Outcome regress(const std::string& command, const std::vector<std::string>& more = {},
                    const std::string& output = "out") const {
        std::vector<std::string> words = {command, "--manifest", folder_ / "manifest", "--output",
                                          folder_ / output};
        words.insert(words.end(), more.begin(), more.end());
        return run_app(run_regress_app, "flownav-regress", words);
    }
    Outcome run(std::vector<std::string> more = {}, const std::string& output = "out") const {
        more.insert(more.end(), {"--program", program()});
        return regress("run", more, output);
    }

    std::filesystem::path program() const { return folder_ / "replay"; }
    std::string text_of(const std::string& file) const {
        std::ifstream stream(folder_ / file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    bool has(const std::string& file) const { return std::filesystem::exists(folder_ / file); }
    std::string calls() const { return text_of("calls"); }

    /// Called as RAWLOG --output DIR --config INI --quiet. Its timing differs from run to run.
    static constexpr auto script = R"sh(
folder=$(dirname "$0")
read -r what id < "$1"
echo "$id" >> "$folder/calls"
summary() {
    echo "{\"drive\": {\"duration_s\": 2.5}, \"status\": {\"ok\": $1}, \"timing\": {\"total_s\": $$}}" > "$3/summary.json"
}
tau=$(sed -n 's/tau_px = //p' "$5")
case $what in
    fine) summary "1${#id}${tau}" "" "$3"; echo "way of $id" > "$3/trajectory.tum" ;;
    damaged) summary 3 "" "$3"; echo "first line" >&2; echo "it is damaged" >&2; exit 2 ;;
    crash) kill -SEGV $$ ;;
    hang) echo now > "$folder/started"; exec tail -f /dev/null ;;
    unwritable) echo "no space" >&2; exit 3 ;;
esac
)sh";

    std::filesystem::path folder_;
    std::string lines_;
};

}  // namespace flownav::testing
