#pragma once
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

/// Parts of the serialization of CObservationFlowField. Reading throws std::runtime_error on invalid numbers.
namespace flownav::io::archive {

using mrpt::serialization::CArchive;

constexpr std::uint32_t most_elements = 1U << 20;

/// Index of a value in the list of stored values.
template <typename Word, std::size_t N>
std::uint8_t number_of(Word word, const std::array<Word, N>& words) {
    return static_cast<std::uint8_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

template <typename Word, std::size_t N>
Word read_word(CArchive& in, const std::array<Word, N>& words, const char* name) {
    const auto number = in.ReadAs<std::uint8_t>();
    if (number < N) return words[number];
    throw std::runtime_error("flow field: " + std::string(name) + " has the number " +
                             std::to_string(number) + ", known are 0.." + std::to_string(N - 1));
}

/// Writes flags as bits of one byte, the first flag in the lowest bit.
inline void write_flags(CArchive& out, std::initializer_list<bool> flags) {
    unsigned bits = 0;
    unsigned place = 0;
    for (const bool flag : flags) bits |= static_cast<unsigned>(flag) << place++;
    out << static_cast<std::uint8_t>(bits);
}

inline void read_flags(CArchive& in, std::initializer_list<bool*> flags) {
    unsigned bits = in.ReadAs<std::uint8_t>();
    for (bool* flag : flags) {
        *flag = (bits & 1U) != 0;
        bits >>= 1U;
    }
    if (bits != 0) throw std::runtime_error("flow field: a flag is set that does not exist");
}

/// A row of N doubles, written and read as one buffer.
template <std::size_t N>
using Numbers = std::array<double, N>;

template <std::size_t N>
void write_numbers(CArchive& out, const Numbers<N>& numbers) {
    out.WriteBufferFixEndianness(numbers.data(), N);
}

template <std::size_t N>
Numbers<N> read_numbers(CArchive& in) {
    Numbers<N> numbers{};
    if (in.ReadBufferFixEndianness(numbers.data(), N) != sizeof(numbers))
        throw std::runtime_error("flow field: ends in the middle of its numbers");
    return numbers;
}

template <typename Element, typename Write>
void write_list(CArchive& out, const std::vector<Element>& list, Write write_element) {
    out.WriteAs<std::uint32_t>(list.size());
    for (const Element& element : list) write_element(out, element);
}

/// Reads a list element by element, so that a damaged length does not allocate memory for it.
template <typename Read>
auto read_list(CArchive& in, const char* name, Read read_element) {
    std::vector<decltype(read_element(in))> list;
    const auto size = in.ReadAs<std::uint32_t>();
    if (size > most_elements) {
        throw std::runtime_error("flow field: " + std::to_string(size) + ' ' + name + " are more than the " +
                                 std::to_string(most_elements) + " that can be: the file is damaged");
    }
    for (std::uint32_t i = 0; i < size; ++i) list.push_back(read_element(in));
    return list;
}

/// Legend of the stored numbers, such as "0 = ok, 1 = waiting, ...".
template <typename Word, std::size_t N>
std::string explained(const std::array<Word, N>& words) {
    std::string text;
    for (std::size_t i = 0; i < N; ++i)
        text += (i == 0 ? "" : ", ") + std::to_string(i) + " = " + to_string(words[i]);
    return text;
}

}  // namespace flownav::io::archive
