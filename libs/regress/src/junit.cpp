#include "flownav/regress/junit.h"

#include <tinyxml2.h>

#include <map>

namespace flownav::regress {

namespace {

std::string sentence(const Deviation& deviation) {
    return deviation.figure.empty() ? deviation.message : deviation.figure + ": " + deviation.message;
}

}  // namespace

std::string junit_xml(const std::string& suite, const RunResults& results,
                      const std::vector<Deviation>& deviations) {
    std::map<std::string, std::vector<std::string>> failures;
    for (const RawlogResult& rawlog : results) failures[rawlog.id];
    for (const Deviation& deviation : deviations) failures[deviation.id].push_back(sentence(deviation));
    int failed = 0;
    for (const auto& [id, sentences] : failures) failed += sentences.empty() ? 0 : 1;

    tinyxml2::XMLPrinter xml;
    xml.PushHeader(false, true);
    xml.OpenElement("testsuite");
    xml.PushAttribute("name", suite.c_str());
    xml.PushAttribute("tests", static_cast<int>(failures.size()));
    xml.PushAttribute("failures", failed);
    for (const auto& [id, sentences] : failures) {
        xml.OpenElement("testcase");
        xml.PushAttribute("classname", suite.c_str());
        xml.PushAttribute("name", id.c_str());
        if (!sentences.empty()) {
            std::string text;
            for (const std::string& line : sentences) text += line + '\n';
            xml.OpenElement("failure");
            xml.PushAttribute("message", sentences.front().c_str());
            xml.PushText(text.c_str());
            xml.CloseElement();
        }
        xml.CloseElement();
    }
    xml.CloseElement();
    return xml.CStr();
}

}  // namespace flownav::regress
