#pragma once

#include <string>
#include <string_view>

namespace clothlab::test {

// What must hold for any text whatever that is read as a scene: a scene without errors or errors without a
// scene, words for each, and a scene that is written and read back the same. Returns what does not hold.
std::string brokenInvariant(std::string_view text);

} // namespace clothlab::test
