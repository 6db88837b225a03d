// In a tree that `./dev demo` or `./dev test` makes (-Db_pch=true), which is built once:
// precompiled once a library and given to each of its sources, as reading these headers is a third
// of a build from nothing. Other trees do without, as ccache serves them better; so sources include
// what they use all the same. Headers of the project have no place here: a change of one would
// compile the whole library.

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>
