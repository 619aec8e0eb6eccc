#include "sdf_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iostream>
#include <sdf/Element.hh>
#include <sdf/ParserConfig.hh>
#include <sdf/parser.hh>
#include <sstream>
#include <string_view>

#include "flownav/sim/sdf_world.h"

namespace flownav::sim {
namespace {

// Elements without meaning here. libsdformat copies the whole schema into every element it reads: without
// these a world with 365 models takes a quarter of the time, and of the memory, which would be 1 GB.
constexpr std::array<std::string_view, 24> unused = {
    "animation", "atmosphere", "audio",  "audio_sink", "audio_source", "battery", "gripper",
    "gui",       "heightmap",  "image",  "inertial",   "joint",        "light",   "particle_emitter",
    "pbr",       "physics",    "plugin", "population", "road",         "scene",   "sensor",
    "skin",      "state",      "surface"};

bool is_unused(const std::string& name) {
    return std::find(unused.begin(), unused.end(), name) != unused.end();
}

sdf::ElementPtr lean_schema(const sdf::ElementPtr& full) {
    auto lean = std::make_shared<sdf::Element>();
    lean->SetName(full->GetName());
    lean->SetRequired(full->GetRequired());
    lean->SetReferenceSDF(full->ReferenceSDF());
    lean->SetCopyChildren(full->GetCopyChildren());
    for (unsigned i = 0; i < full->GetAttributeCount(); ++i) {
        const sdf::ParamPtr a = full->GetAttribute(i);
        lean->AddAttribute(a->GetKey(), a->GetTypeName(), a->GetDefaultAsString(), a->GetRequired());
    }
    if (const sdf::ParamPtr value = full->GetValue())
        lean->AddValue(value->GetTypeName(), value->GetDefaultAsString(), value->GetRequired());
    for (unsigned i = 0; i < full->GetElementDescriptionCount(); ++i) {
        const sdf::ElementPtr child = full->GetElementDescription(i);
        if (!is_unused(child->GetName())) lean->AddElementDescription(lean_schema(child));
    }
    return lean;
}

/// Catches what the library writes to std::cerr as long as this lives.
class CaughtMessages {
  public:
    CaughtMessages() : before_(std::cerr.rdbuf(text_.rdbuf())) {}
    ~CaughtMessages() { std::cerr.rdbuf(before_); }
    CaughtMessages(const CaughtMessages&) = delete;
    CaughtMessages& operator=(const CaughtMessages&) = delete;

    /// The first message, without colours and places in the library.
    std::string first() const {
        std::istringstream lines(text_.str());
        std::string line;
        std::getline(lines, line);
        for (auto colour = line.find('\x1b'); colour != std::string::npos; colour = line.find('\x1b'))
            line.erase(colour, std::min(line.find('m', colour), line.size() - 1) - colour + 1);
        const auto place = line.find(" [");  // "Error [Param.cc:42] ..."
        if (place != std::string::npos && line.find(' ') == place) line.erase(0, line.find(']') + 1);
        return line.substr(std::min(line.size(), line.find_first_not_of(' ')));
    }

  private:
    std::ostringstream text_;
    std::streambuf* before_;
};

[[noreturn]] void refuse(const std::filesystem::path& file, std::optional<int> line,
                         const std::string& what) {
    throw WorldError(file.string() + (line ? ":" + std::to_string(*line) : "") + ": " + what);
}

/// The library says the line of broken XML in its console message only.
std::optional<int> line_in(const std::string& message) {
    const std::string mark = "ine number=";
    const auto at = message.find(mark);
    int line = 0;
    const char* const first = message.data() + (at == std::string::npos ? 0 : at + mark.size());
    const auto read = std::from_chars(first, message.data() + message.size(), line);
    if (at == std::string::npos || read.ec != std::errc()) return std::nullopt;
    return line;
}

void check_exists(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) refuse(file, std::nullopt, "no such file");
    if (!std::filesystem::is_regular_file(file, error)) refuse(file, std::nullopt, "is not a file");
}

/// Takes out what has no meaning here, the included models among it, and puts the actors aside.
void prune(const sdf::ElementPtr& parent, SdfFile& file) {
    for (sdf::ElementPtr child = parent->GetFirstElement(); child;) {
        const sdf::ElementPtr next = child->GetNextElement();
        if (child->GetIncludeElement()) {
            file.warnings.push_back("include of " + child->GetIncludeElement()->Get<std::string>("uri") +
                                    " is left out");
            parent->RemoveChild(child);
        } else if (is_unused(child->GetName())) {
            parent->RemoveChild(child);
        } else {
            prune(child, file);
            if (child->GetName() == "actor") {
                file.actors.push_back(child);
                parent->RemoveChild(child);
            }
        }
        child = next;
    }
}

sdf::SDFPtr parse(const std::filesystem::path& file, std::vector<std::string>& warnings) {
    auto text = std::make_shared<sdf::SDF>();
    sdf::ParserConfig config;
    config.SetFindCallback([](const std::string&) { return std::string(); });
    sdf::Errors errors;
    bool read = false;
    const CaughtMessages messages;
    if (!sdf::init(text)) refuse(file, std::nullopt, "libsdformat does not find its schema");
    text->Root(lean_schema(text->Root()));
    read = sdf::readFile(file.string(), config, text, errors);
    for (const sdf::Error& error : errors) {
        if (error.Code() == sdf::ErrorCode::URI_LOOKUP || error.Code() == sdf::ErrorCode::URI_INVALID) {
            warnings.push_back("include is left out: " + error.Message());
        } else {
            const std::string more = messages.first();
            refuse(file, error.LineNumber() ? error.LineNumber() : line_in(more),
                   error.Message() + (more.empty() ? "" : " (" + more + ")"));
        }
    }
    if (!read) refuse(file, line_in(messages.first()), "is not SDF: " + messages.first());
    return text;
}

}  // namespace

SdfFile read_sdf_file(const std::filesystem::path& file) {
    check_exists(file);
    SdfFile result;
    const sdf::SDFPtr text = parse(file, result.warnings);
    prune(text->Root(), result);
    const CaughtMessages messages;
    const sdf::Errors errors = result.root.Load(text, sdf::ParserConfig());
    if (!errors.empty()) refuse(file, errors.front().LineNumber(), errors.front().Message());
    if (result.root.WorldCount() == 0) refuse(file, std::nullopt, "holds no world");
    return result;
}

}  // namespace flownav::sim
