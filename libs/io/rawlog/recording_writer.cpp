#include "flownav/io/recording_writer.h"

#include <limits>

#include "flownav/io/drive_recording.h"
#include "flownav/io/field_splitter.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::io {

RecordingCounts write_recording(ImageSequence& sequence, const RecordingOptions& options) {
    DriveRecording recording(options.output, options.camera_label);
    FieldSplitter splitter(options.interlaced);
    RecordingCounts counts;
    const auto write_fields = [&](const std::vector<Field>& fields) {
        for (const Field& field : fields) recording.write(field);
        counts.fields += fields.size();
    };
    const std::vector<GyroRate> gyro = sequence.gyro();
    const auto write_gyro_until = [&](double timestamp_s) {
        for (; counts.gyro < gyro.size() && gyro[counts.gyro].timestamp_s <= timestamp_s; ++counts.gyro)
            recording.write_gyro(gyro[counts.gyro]);
    };
    while (const auto frame = sequence.next()) {
        ++counts.frames;
        write_gyro_until(frame->field.timestamp_s);
        write_fields(splitter.push(frame->field));
        if (frame->T_start_robot) {
            recording.write_truth(frame->field.timestamp_s, *frame->T_start_robot);
            ++counts.poses;
        }
        const auto size = static_cast<double>(sequence.size());
        const double share = size > 0 ? static_cast<double>(counts.frames) / size : 0.0;
        if (options.progress) options.progress(share, counts.fields);
    }
    if (counts.frames == 0) {
        const auto& problems = sequence.problems();
        throw InputError("no image could be read" + (problems.empty() ? "" : ": " + problems.front()));
    }
    write_fields(splitter.finish());
    write_gyro_until(std::numeric_limits<double>::infinity());
    if (options.progress) options.progress(1.0, counts.fields);
    recording.complete();
    return counts;
}

}  // namespace flownav::io
