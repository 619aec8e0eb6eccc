#pragma once
#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace flownav {

/// The names as "a | b | c".
inline std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " | ") + name;
    return text;
}

/// Values by name, in the order of their registration. Several threads may use it at the same time.
template <class Value>
class Registry {
  public:
    using Entry = std::pair<std::string, Value>;

    /// `kind` names a value in messages, such as "matcher".
    Registry(std::string kind, std::vector<Entry> built_in)
        : kind_(std::move(kind)), entries_(std::move(built_in)) {}

    /// Adds a value. Throws std::invalid_argument: the name is taken, empty, or holds other characters than
    /// a-z, 0-9 and _.
    void add(const std::string& name, Value value) {
        const auto allowed = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
        };
        if (name.empty() || !std::all_of(name.begin(), name.end(), allowed))
            throw std::invalid_argument(kind_ + " '" + name + "': a name consists of a-z, 0-9 and _");
        const std::lock_guard lock(mutex_);
        for (const Entry& entry : entries_)
            if (entry.first == name)
                throw std::invalid_argument(kind_ + " '" + name + "' is registered already");
        entries_.emplace_back(name, std::move(value));
    }

    /// Returns the value of a name. Throws std::invalid_argument, which lists the known names.
    Value find(const std::string& name) const {
        {
            const std::lock_guard lock(mutex_);
            for (const Entry& entry : entries_)
                if (entry.first == name) return entry.second;
        }
        throw std::invalid_argument("unknown " + kind_ + " '" + name + "'; known: " + listed(names()));
    }

    std::vector<std::string> names() const {
        const std::lock_guard lock(mutex_);
        std::vector<std::string> all;
        for (const Entry& entry : entries_) all.push_back(entry.first);
        return all;
    }

  private:
    std::string kind_;
    mutable std::mutex mutex_;
    std::vector<Entry> entries_;
};

}  // namespace flownav
