#include "flownav/core/registry.h"

#include <gtest/gtest.h>

#include <functional>

namespace flownav {
namespace {

std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Registry, ValuesAreFoundByNameInTheOrderOfRegistration) {
    Registry<int> numbers("number", {{"two", 2}});
    numbers.add("one", 1);
    EXPECT_EQ(numbers.find("two"), 2);
    EXPECT_EQ(numbers.find("one"), 1);
    EXPECT_EQ(listed(numbers.names()), "two | one");
}

TEST(Registry, AnUnknownNameIsRefusedWithTheKnownOnes) {
    const Registry<int> numbers("number", {{"one", 1}, {"two", 2}});
    EXPECT_EQ(error_of([&] { numbers.find("three"); }), "unknown number 'three'; known: one | two");
}

TEST(Registry, ANameThatIsTakenOrUnusableIsRefused) {
    Registry<int> numbers("number", {{"one", 1}});
    EXPECT_EQ(error_of([&] { numbers.add("one", 3); }), "number 'one' is registered already");
    for (const char* name : {"", "a b", "A", "a|b", "a\n", "\xC3\xA4"})
        EXPECT_NE(error_of([&] { numbers.add(name, 3); }), "") << name;
    EXPECT_EQ(numbers.find("one"), 1);
    EXPECT_EQ(numbers.names().size(), 1U);
}

}  // namespace
}  // namespace flownav
