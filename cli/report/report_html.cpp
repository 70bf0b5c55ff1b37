#include "cli/report/report_html.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace glint::cli {
namespace {

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) out += k <= count ? digits[group >> (18 - 6 * k) & 63U] : '=';
    }
    return out;
}

std::string_view css_class(Cell::Kind kind) {
    if (kind == Cell::number) return " class=\"number\"";
    return kind == Cell::words ? " class=\"words\"" : "";
}

std::string image_source(const Pictures& pictures, const std::string& file) {
    const std::string_view type = file.ends_with(".png") ? "image/png" : "image/svg+xml";
    return fmt::format("data:{};base64,{}", type, base64(pictures.at(file)));
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string command_html(std::string_view command) {
    std::string out = "<code>";
    for (std::size_t begin = 0; begin <= command.size();) {
        const std::size_t end = std::min(command.find(' ', begin), command.size());
        out += fmt::format("{}<span>{}</span>", begin > 0 ? " " : "", escaped(command.substr(begin, end - begin)));
        begin = end + 1;
    }
    return out + "</code>";
}

std::string grouped(std::uint64_t number) {
    std::string out = fmt::format("{}", number);
    for (std::size_t i = out.size(); i > 3; i -= 3) out.insert(i - 3, 1, ',');
    return out;
}

std::string table_html(const std::vector<std::vector<Cell>>& rows) {
    std::string out = "<div class=\"scroll\">\n<table>\n<thead><tr>";
    for (const Cell& cell : rows.front()) {
        out += fmt::format("<th scope=\"col\"{}>{}</th>", css_class(cell.kind), escaped(cell.label));
    }
    out += "</tr></thead>\n<tbody>\n";
    for (const std::vector<Cell>& row : rows) {
        out += "<tr>";
        for (const Cell& cell : row) {
            if (&cell == &row.front()) {
                out += fmt::format("<th scope=\"row\"{}>{}</th>", css_class(cell.kind), cell.html);
            } else {
                out += fmt::format("<td data-label=\"{}\"{}><span>{}</span></td>", escaped(cell.label),
                                   css_class(cell.kind), cell.html);
            }
        }
        out += "</tr>\n";
    }
    return out + "</tbody>\n</table>\n</div>\n";
}

std::string figure_html(const Pictures& pictures, const Plot& plot, const std::string& alternative,
                        const std::string& caption) {
    std::string out = "<figure>\n<picture>\n";
    for (const std::string_view theme : {"dark", "light"}) {
        for (const std::string_view layout : {"narrow", "wide"}) {
            if (theme == "light" && layout == "wide") continue;
            std::string media = theme == "dark" ? "(prefers-color-scheme: dark)" : "";
            if (layout == "narrow") media += media.empty() ? "(max-width: 40rem)" : " and (max-width: 40rem)";
            out += fmt::format("<source media=\"{}\" srcset=\"{}\">\n", media,
                               image_source(pictures, plot.file(theme, layout)));
        }
    }
    out += fmt::format("<img alt=\"{}\" src=\"{}\">\n</picture>\n<figcaption>{}</figcaption>\n</figure>\n",
                       escaped(alternative), image_source(pictures, plot.file("light", "wide")), caption);
    return out;
}

}  // namespace glint::cli
