#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace flownav::regress {

/// One rawlog of a manifest.
struct ManifestEntry {
    std::string id;                ///< name of its results; stays the same when the manifest is reordered
    std::filesystem::path rawlog;  ///< relative to the root, or absolute
    std::string sha256;            ///< of the file, 64 hexadecimal digits
    std::filesystem::path config;  ///< ini of this rawlog, relative to the root; empty: none
    std::vector<std::string> settings;  ///< section.key=value
};

using Manifest = std::vector<ManifestEntry>;

/// Parses the text of a manifest; `name` is for messages. Throws UsageError that names the line: too few
/// fields, an identifier that is not a unique file name, no sha256, a setting without '='.
Manifest parse_manifest(const std::string& text, const std::string& name);

/// Reads a manifest. Throws UsageError when the file cannot be read, or as parse_manifest does.
Manifest read_manifest(const std::filesystem::path& file);

/// Writes one line per rawlog (*.rawlog, *.rawlog.gz) below `folder`, sorted by path; paths are relative to
/// `root`. The identifier is the path below `folder` without the extension, with '/' replaced by '-'. Throws
/// UsageError for a missing folder, no rawlogs, or two equal identifiers.
std::string manifest_of_folder(const std::filesystem::path& folder, const std::filesystem::path& root);

}  // namespace flownav::regress
