// JUnit XML, as far as CI systems read it.
#pragma once

#include <string>
#include <vector>

namespace glint::testbench {

struct JUnitCase {
    std::string name;
    double seconds = 0.0;
    std::string failure;  ///< empty: passed
};

std::string to_junit(const std::string& suite, const std::vector<JUnitCase>& cases);

}  // namespace glint::testbench
