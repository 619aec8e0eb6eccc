#include "flownav/regress/sha256.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <vector>

namespace flownav::regress {

namespace {

constexpr std::size_t chunk_bytes = 1 << 20;
constexpr std::size_t digits = 64;

class Digest {
  public:
    Digest() { EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr); }

    void add(const void* bytes, std::size_t count) { EVP_DigestUpdate(context_.get(), bytes, count); }

    std::string hex() {
        std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
        unsigned count = 0;
        EVP_DigestFinal_ex(context_.get(), bytes.data(), &count);
        std::string text;
        for (unsigned i = 0; i < count; ++i) {
            constexpr auto hexadecimal = "0123456789abcdef";
            text += hexadecimal[bytes.at(i) >> 4U];
            text += hexadecimal[bytes.at(i) & 15U];
        }
        return text;
    }

  private:
    struct Free {
        void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
    };
    std::unique_ptr<EVP_MD_CTX, Free> context_{EVP_MD_CTX_new()};
};

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail(const std::filesystem::path& file) {
    throw std::system_error(errno, std::generic_category(), "cannot read " + file.string());
}

}  // namespace

std::string sha256_of_text(std::string_view text) {
    Digest digest;
    digest.add(text.data(), text.size());
    return digest.hex();
}

std::string sha256_of_file(const std::filesystem::path& file) {
    const std::unique_ptr<std::FILE, Close> stream(std::fopen(file.c_str(), "rbe"));
    if (!stream) fail(file);
    Digest digest;
    std::vector<unsigned char> chunk(chunk_bytes);
    while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), stream.get()))
        digest.add(chunk.data(), count);
    if (std::ferror(stream.get()) != 0) fail(file);
    return digest.hex();
}

bool is_sha256(std::string_view text) {
    const auto hexadecimal = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    return text.size() == digits && std::all_of(text.begin(), text.end(), hexadecimal);
}

}  // namespace flownav::regress
