#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "glint/error.hpp"

namespace glint::render {
namespace {

constexpr std::string_view blanks = " \t\v\f";
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// Where the comment of a name begins: at a '#' with a blank or nothing on both sides.
std::size_t comment(std::string_view text) {
    const auto blank = [&](std::size_t i) { return i >= text.size() || blanks.find(text[i]) != blanks.npos; };
    for (std::size_t i = text.find('#'); i != text.npos; i = text.find('#', i + 1)) {
        if ((i == 0 || blank(i - 1)) && blank(i + 1)) return i;
    }
    return text.size();
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
    std::error_code unknown;
    std::ostringstream text;
    std::ifstream file;
    if (std::filesystem::is_regular_file(path, unknown)) file.open(path, std::ios::binary);
    if (!file.is_open()) throw Error(fmt::format("file '{}' cannot be read", printable(path.string(), 200)));
    // An empty file gives no characters, which is no error.
    if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
    return std::move(text).str();
}

void check_text(std::string_view text, const std::string& file) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
        throw Error(fmt::format("{}: this is UTF-16 text, which is not legal: ASCII or UTF-8", file));
    }
    const std::size_t zero = text.find('\0');
    if (zero != text.npos) throw Error(fmt::format("{}: byte {} is 0: this is no text in ASCII or UTF-8", file, zero));
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

std::string_view Lines::physical() {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    std::string_view out = text_.substr(at_, end - at_);
    at_ = end + (text_.substr(end).starts_with("\r\n") ? 2 : 1);
    ++number_;
    while (out.starts_with(byte_order_mark)) out.remove_prefix(byte_order_mark.size());
    return trimmed(out);
}

bool Lines::next(Line& line) {
    while (at_ < text_.size()) {
        std::string_view text = physical();
        line.number = number_;
        const std::string_view key = text.substr(0, text.find_first_of(blanks));
        if (text.empty() || text.starts_with('#')) continue;
        if (std::find(names_.begin(), names_.end(), key) != names_.end()) {
            const std::string_view rest = trimmed(text.substr(key.size()));
            line.key = key;
            line.rest = trimmed(rest.substr(0, comment(rest)));
            return true;
        }
        const auto goes_on = [&] { return text.ends_with('\\') && text.find('#') == text.npos; };
        if (goes_on()) {
            joined_.clear();
            for (; goes_on() && at_ < text_.size(); text = physical()) joined_.append(text, 0, text.size() - 1) += ' ';
            if (text.ends_with('\\')) text.remove_suffix(1);
            joined_ += text;
            text = joined_;
        }
        text = trimmed(text.substr(0, text.find('#')));
        line.key = text.substr(0, text.find_first_of(blanks));
        line.rest = trimmed(text.substr(line.key.size()));
        if (!line.key.empty()) return true;
    }
    return false;
}

std::vector<std::string_view> fields(std::string_view text) {
    std::vector<std::string_view> out;
    for (std::size_t at = text.find_first_not_of(blanks); at != text.npos; at = text.find_first_not_of(blanks, at)) {
        const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
        out.push_back(text.substr(at, end - at));
        at = end;
    }
    return out;
}

bool parse_number(std::string_view field, double largest, double& out) {
    if (field.starts_with('+')) {
        field.remove_prefix(1);
        if (field.starts_with('+') || field.starts_with('-')) return false;
    }
    out = 0.0;
    const char* const end = field.data() + field.size();
    const auto [stopped, error] = std::from_chars(field.data(), end, out);
    if (error == std::errc::result_out_of_range && stopped == end) {
        out = std::strtod(std::string(field).c_str(), nullptr);  // next to 0, or infinite
    } else if (error != std::errc{} || stopped != end) {
        return false;
    }
    return std::abs(out) <= largest;
}

std::string printable(std::string_view text, std::size_t most) {
    std::string out;
    std::size_t characters = 0;
    for (std::size_t i = 0; i < text.size(); ++characters) {
        if (characters == most) {
            out += "...";
            break;
        }
        const auto byte = static_cast<unsigned char>(text[i]);
        const std::size_t length = byte < 0x80   ? 1
                                   : byte < 0xc2 ? 0
                                   : byte < 0xe0 ? 2
                                   : byte < 0xf0 ? 3
                                   : byte < 0xf5 ? 4
                                                 : 0;
        bool good = length != 0 && i + length <= text.size();
        for (std::size_t k = 1; good && k < length; ++k) {
            const auto next = static_cast<unsigned char>(text[i + k]);
            good = (next & 0xc0U) == 0x80U;
            // Longer than need be, a half of a pair of UTF-16, or above U+10FFFF.
            if (k == 1 && ((byte == 0xe0 && next < 0xa0) || (byte == 0xed && next > 0x9f) ||
                           (byte == 0xf0 && next < 0x90) || (byte == 0xf4 && next > 0x8f))) {
                good = false;
            }
        }
        if (!good) {
            out += '?';
            ++i;
        } else {
            out += byte < 0x20 || byte == 0x7f ? std::string(1, ' ') : std::string(text.substr(i, length));
            i += length;
        }
    }
    out.erase(out.find_last_not_of(' ') + 1);
    return out;
}

}  // namespace glint::render
