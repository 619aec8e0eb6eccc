#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace flownav::regress {

/// One rawlog of a manifest.
struct ManifestEntry {
    std::string id;                ///< names its results; never changes, unlike its place in the manifest
    std::filesystem::path rawlog;  ///< from the root, or absolute
    std::string sha256;            ///< of the file, 64 hexadecimal digits
    std::filesystem::path config;  ///< an ini of its own, from the root; empty: none
    std::vector<std::string> settings;  ///< section.key=value
};

using Manifest = std::vector<ManifestEntry>;

/// The entries of a manifest's text; `name` is for messages. Throws UsageError that names the line: too few
/// fields, an identifier that is no file name or not unique, no sha256, a setting without '='.
Manifest parse_manifest(const std::string& text, const std::string& name);

/// Throws UsageError when the file cannot be read, or as parse_manifest does.
Manifest read_manifest(const std::filesystem::path& file);

/// A line a rawlog (*.rawlog, *.rawlog.gz) below `folder`, sorted by path; paths are relative to `root`. Its
/// identifier is its path below `folder` without the ending, '/' replaced by '-'. Throws UsageError where
/// there is no folder or no rawlog, or two would have the same identifier.
std::string manifest_of_folder(const std::filesystem::path& folder, const std::filesystem::path& root);

}  // namespace flownav::regress
