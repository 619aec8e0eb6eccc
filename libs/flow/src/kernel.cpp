#include "flownav/flow/kernel.h"

#include <algorithm>
#include <stdexcept>

#include "kernel_portable.h"

namespace flownav {
namespace {

constexpr int index_of(int mu, int nu) {
    return (nu - search_min) * search_px + (mu - search_min);
}

struct Offset {
    int mu, nu;
};

/// Every offset in the order of the tie-break: the first of several equal costs wins.
std::array<Offset, search_offsets> tie_break_order() {
    std::array<Offset, search_offsets> order{};
    for (int nu = search_min; nu <= search_max; ++nu) {
        for (int mu = search_min; mu <= search_max; ++mu) order[index_of(mu, nu)] = {mu, nu};
    }
    std::stable_sort(order.begin(), order.end(), [](const Offset& p, const Offset& q) {
        return p.mu * p.mu + p.nu * p.nu < q.mu * q.mu + q.nu * q.nu;
    });
    return order;
}

bool inside(const Offset& d, const SearchRange& r) {
    return d.mu >= r.mu_min && d.mu <= r.mu_max && d.nu >= r.nu_min && d.nu <= r.nu_max;
}

bool distinct(const Offset& d, const BlockMatch& best) {
    return std::max(std::abs(d.mu - best.mu), std::abs(d.nu - best.nu)) >= distinct_px;
}

std::uint16_t cost_at(const SadSurface& surface, const SearchRange& range, const Offset& d) {
    return inside(d, range) ? surface[index_of(d.mu, d.nu)] : no_cost;
}

}  // namespace

BlockMatch summarise(const SadSurface& surface, const SearchRange& range) {
    static const auto order = tie_break_order();
    BlockMatch m;
    for (const Offset& d : order) {
        const std::uint16_t cost = surface[index_of(d.mu, d.nu)];
        if (cost == no_cost) continue;
        m.sum += cost;
        if (cost < m.minimum) {
            m.minimum = cost;
            m.mu = d.mu;
            m.nu = d.nu;
        }
    }
    for (const Offset& d : order) {
        const std::uint16_t cost = surface[index_of(d.mu, d.nu)];
        if (cost < m.second && distinct(d, m)) m.second = cost;
    }
    m.left = cost_at(surface, range, {m.mu - 1, m.nu});
    m.right = cost_at(surface, range, {m.mu + 1, m.nu});
    m.above = cost_at(surface, range, {m.mu, m.nu - 1});
    m.below = cost_at(surface, range, {m.mu, m.nu + 1});
    return m;
}

const std::vector<KernelEntry>& kernel_table() {
    static const std::vector<KernelEntry> table = {{"portable", [] { return true; }, match_portable}};
    return table;
}

const KernelEntry& select_kernel(const std::string& name) {
    const auto& table = kernel_table();
    const auto found = std::find_if(table.begin(), table.end(), [&](const KernelEntry& k) {
        return name.empty() ? k.supported() : name == k.name;
    });
    if (found == table.end()) {
        std::string known;
        for (const KernelEntry& k : table) known += std::string(known.empty() ? "" : ", ") + k.name;
        throw std::runtime_error("matching kernel '" + name + "' is unknown; known: " + known);
    }
    if (!found->supported()) {
        throw std::runtime_error("matching kernel '" + name + "' is not supported by this processor");
    }
    return *found;
}

}  // namespace flownav
