// Precompiled headers serve trees that are built once, by `./dev demo` or `./dev test`
// (-Db_pch=true). They are precompiled once for each library, as reading them is a third of a full
// build. Other trees do without, as ccache serves them better, so sources must still include what
// they use. Headers of the project do not belong here: changing one would recompile the whole
// library.

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
