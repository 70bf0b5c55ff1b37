// Text files of others: one definition of a line, a field and a number, for all that reads OBJ and MTL.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glint::render {

/// The bytes of a regular file. Throws Error where it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Throws Error where TEXT is UTF-16 or holds a byte 0; `file` names it.
void check_text(std::string_view text, const std::string& file);

/// A line without its comment and without the blanks around it.
struct Line {
    int number = 0;         ///< of its first line in the file, from 1
    std::string_view key;   ///< the first word; never empty
    std::string_view rest;  ///< what follows, as it stands
};

/// The lines of a text that hold anything. A line ends at LF, CR or CRLF. A byte order mark at its start is skipped. A
/// backslash at the end of a line continues it, unless its key is one of `names`, whose value is a text that may end in
/// one; there, a comment begins at a `#` between blanks. Elsewhere it begins at any `#`.
class Lines {
public:
    Lines(std::string_view text, const std::vector<std::string_view>& names) : text_(text), names_(names) {}
    /// False at the end of the text. The views of `line` hold until the next call.
    bool next(Line& line);

private:
    std::string_view physical();

    std::string_view text_;
    const std::vector<std::string_view>& names_;
    std::size_t at_ = 0;
    int number_ = 0;
    std::string joined_;
};

std::string_view trimmed(std::string_view text);

/// With a to z for A to Z.
std::string lower(std::string text);

/// The words between blanks.
std::vector<std::string_view> fields(std::string_view text);

/// True where FIELD is a decimal number of at most that size, such as `1`, `+.5`, `-2.e-3`. Numbers next to 0 are 0.
bool parse_number(std::string_view field, double largest, double& out);

/// Text of a file for a message or a JSON file: one line, at most `most` characters, in UTF-8: bytes that are none
/// become '?'.
std::string printable(std::string_view text, std::size_t most = 60);

}  // namespace glint::render
