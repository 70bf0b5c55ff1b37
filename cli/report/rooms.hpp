// The rooms whose names the report uses.
#pragma once

namespace glint {
namespace io {}
namespace cost {}
namespace fpga {}
namespace studies {}
}  // namespace glint

namespace glint::cli {
using namespace io;
using namespace cost;
using namespace fpga;
using namespace studies;
}  // namespace glint::cli
