#include "row_file.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>

namespace flownav {
namespace {

constexpr const char* header =
    "fault,seed,outcome,speed_mps,distance_m,stop_s,allowed_s,way_m,reason,contact_mps,min_clearance_m,"
    "drives_on,"
    "after_fault_s,stops_before,cpu_s";

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

std::string reasons_of(const std::vector<RunRow>& rows) {
    std::map<std::string, int> counts;
    for (const RunRow& row : rows) ++counts[row.reason];
    std::string text;
    for (const auto& [reason, count] : counts)
        text += (text.empty() ? "" : ", ") + reason + " " + std::to_string(count);
    return text;
}

std::string line_of(const std::string& fault, const std::vector<RunRow>& rows) {
    std::vector<double> stops, ways, resumes, contacts;
    int stood = 0, in_time = 0, collisions = 0, on = 0, early = 0;
    for (const RunRow& row : rows) {
        stood += row.stop_s >= 0.0;
        in_time += row.stop_s >= 0.0 && row.stop_s <= row.allowed_s + 1e-9;
        collisions += row.outcome == "collision";
        on += row.drives_on;
        early += row.stops_before;
        if (row.stop_s >= 0.0) stops.push_back(row.stop_s);
        if (row.stop_s >= 0.0) ways.push_back(row.way_m);
        if (row.after_fault_s >= 0.0) resumes.push_back(row.after_fault_s);
        if (row.outcome == "collision") contacts.push_back(row.contact_mps);
    }
    std::ostringstream line;
    line << std::fixed << std::setprecision(2) << "| " << fault << " | " << rows.size() << " | " << collisions
         << " | " << stood << " | " << in_time << " | " << quantile(stops, 0.5) << " / "
         << quantile(stops, 1.0) << " | " << quantile(ways, 0.5) << " / " << quantile(ways, 1.0) << " | "
         << on << " | " << quantile(resumes, 0.5) << " | " << early << " | " << reasons_of(rows) << " | "
         << (contacts.empty() ? 0.0 : quantile(contacts, 1.0)) << " |\n";
    return line.str();
}

}  // namespace

std::vector<RunRow> read_rows(const std::filesystem::path& path) {
    std::vector<RunRow> rows;
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        std::string fault;
        RunRow row;
        if (!(words >> fault >> row.seed >> row.outcome >> row.speed_mps >> row.distance_m >> row.stop_s >>
              row.allowed_s >> row.way_m >> row.reason >> row.contact_mps >> row.min_clearance_m >>
              row.drives_on >> row.after_fault_s >> row.stops_before >> row.cpu_s))
            continue;
        const auto known = std::find_if(all_faults.begin(), all_faults.end(),
                                        [&](Fault f) { return fault == to_string(f); });
        row.fault = known == all_faults.end() ? Fault::None : *known;
        rows.push_back(row);
    }
    return rows;
}

void append_row(const std::filesystem::path& path, const RunRow& row) {
    const bool is_new = !std::filesystem::exists(path);
    std::ofstream file(path, std::ios::app);
    if (is_new) file << header << "\n";
    file << to_string(row.fault) << ',' << row.seed << ',' << row.outcome << ',' << row.speed_mps << ','
         << row.distance_m << ',' << row.stop_s << ',' << row.allowed_s << ',' << row.way_m << ','
         << row.reason << ',' << row.contact_mps << ',' << row.min_clearance_m << ',' << row.drives_on << ','
         << row.after_fault_s << ',' << row.stops_before << ',' << row.cpu_s << '\n';
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

std::string table_of(const std::vector<RunRow>& rows) {
    std::string table =
        "| fault | runs | collisions | stood | in time | until standing, median / max (s) | way, median / "
        "max (m) | "
        "reached the goal afterwards | moves again after (s, median) | false alarms before | first reason of "
        "a stop | "
        "fastest contact (m/s) |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    std::map<Fault, std::vector<RunRow>> by_fault;
    for (const RunRow& row : rows) by_fault[row.fault].push_back(row);
    for (const auto& [fault, of_fault] : by_fault) table += line_of(to_string(fault), of_fault);
    return table;
}

}  // namespace flownav
