#include "flownav/regress/manifest.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>

#include "flownav/cli/usage_error.h"
#include "flownav/regress/sha256.h"

namespace flownav::regress {

namespace {

constexpr std::size_t least_fields = 3;
constexpr std::size_t longest_id = 200;  // with a suffix it must be a file name

constexpr auto allowed_id =
    "an identifier is a file name: letters, digits, '.', '_', '-', '+', '=', not beginning with '.', at most "
    "200 characters";

bool is_id(const std::string& text) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("._-+=").find(c) != std::string_view::npos;
    };
    return !text.empty() && text.size() <= longest_id && text.front() != '.' &&
           std::all_of(text.begin(), text.end(), allowed);
}

/// Splits a line at tabs, or at blanks when it has no tabs.
std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    std::string field;
    if (line.find('\t') == std::string::npos) {
        while (stream >> field) fields.push_back(field);
    } else {
        while (std::getline(stream, field, '\t')) fields.push_back(field);
    }
    return fields;
}

void add_setting(ManifestEntry& entry, const std::string& setting) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos)
        throw cli::UsageError("'" + setting + "': needs the form config=FILE.ini or section.key=value");
    if (setting.compare(0, equals, "config") == 0) {
        entry.config = setting.substr(equals + 1);
    } else {
        entry.settings.push_back(setting);
    }
}

ManifestEntry entry_of(const std::vector<std::string>& fields) {
    if (fields.size() < least_fields)
        throw cli::UsageError(std::to_string(fields.size()) +
                              " field(s), needs at least 3: identifier, path, sha256");
    ManifestEntry entry{fields[0], fields[1], fields[2], {}, {}};
    if (!is_id(entry.id)) throw cli::UsageError("identifier '" + entry.id + "': " + allowed_id);
    if (entry.rawlog.empty()) throw cli::UsageError("'" + entry.id + "' has an empty path");
    if (!is_sha256(entry.sha256))
        throw cli::UsageError("sha256 '" + entry.sha256 + "' of '" + entry.id +
                              "': must be 64 hexadecimal digits in lower case");
    for (std::size_t i = least_fields; i < fields.size(); ++i)
        if (!fields[i].empty()) add_setting(entry, fields[i]);
    return entry;
}

bool says_nothing(const std::string& line) {
    const auto first = line.find_first_not_of(" \t");
    return first == std::string::npos || line[first] == '#';
}

std::string without_ending(const std::string& path) {
    return path.substr(0, path.rfind(".rawlog"));
}

bool is_rawlog(const std::filesystem::path& path) {
    const std::string name = path.filename();
    const auto ends_with = [&name](std::string_view ending) {
        return name.size() > ending.size() &&
               name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
    };
    return ends_with(".rawlog") || ends_with(".rawlog.gz");
}

std::string id_of(const std::filesystem::path& below_folder) {
    std::string id = without_ending(below_folder.generic_string());
    for (char& c : id)
        if (!is_id(std::string("x") + c)) c = '-';
    return id.front() == '.' ? "_" + id : id;
}

std::vector<std::filesystem::path> rawlogs_below(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (std::filesystem::recursive_directory_iterator at(folder, error), end; at != end;
         at.increment(error)) {
        if (error) break;
        if (at->is_regular_file() && is_rawlog(at->path())) files.push_back(at->path());
    }
    if (error) throw cli::UsageError(folder.string() + ": " + error.message());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

Manifest parse_manifest(const std::string& text, const std::string& name) {
    Manifest manifest;
    std::map<std::string, int> line_of_id;
    std::istringstream stream(text);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (says_nothing(line)) continue;
        const std::string place = name + ", line " + std::to_string(number) + ": ";
        try {
            manifest.push_back(entry_of(fields_of(line)));
        } catch (const cli::UsageError& error) {
            throw cli::UsageError(place + error.what());
        }
        const auto [other, is_new] = line_of_id.emplace(manifest.back().id, number);
        if (!is_new)
            throw cli::UsageError(place + "identifier '" + other->first + "' stands in line " +
                                  std::to_string(other->second) + " already");
    }
    if (manifest.empty()) throw cli::UsageError(name + ": no rawlog in it");
    return manifest;
}

Manifest read_manifest(const std::filesystem::path& file) {
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream || std::filesystem::is_directory(file))
        throw cli::UsageError("manifest " + file.string() + ": cannot be read" +
                              (errno != 0 ? ": " + std::generic_category().message(errno) : std::string()));
    return parse_manifest(text.str(), file.string());
}

std::string manifest_of_folder(const std::filesystem::path& folder, const std::filesystem::path& root) {
    std::map<std::string, std::filesystem::path> rawlog_of_id;
    std::string text;
    for (const std::filesystem::path& file : rawlogs_below(folder)) {
        const std::string id = id_of(file.lexically_relative(folder));
        const auto [other, is_new] = rawlog_of_id.emplace(id, file);
        if (!is_new)
            throw cli::UsageError(file.string() + " and " + other->second.string() +
                                  " would have the same identifier '" + id + "': rename one");
        if (file.string().find_first_of("\t\n\r") != std::string::npos)
            throw cli::UsageError(file.string() + ": its path holds a tab or a line end: rename it");
        text +=
            id + '\t' + file.lexically_relative(root).generic_string() + '\t' + sha256_of_file(file) + '\n';
    }
    if (text.empty())
        throw cli::UsageError(folder.string() + ": no *.rawlog and no *.rawlog.gz in it or below");
    return text;
}

}  // namespace flownav::regress
