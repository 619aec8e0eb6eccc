#include "flownav/drive/sensor_feed.h"

#include "flownav/pipeline/sensor_report.h"

namespace flownav::drive {

nav::SensorUpdate sensor_update_of(const pipeline::Step& step, const Field& field,
                                   pipeline::RepeatedImages& images, double epoch_s) {
    nav::SensorUpdate update;
    update.report = pipeline::sensor_report(step, field.camera);
    update.report.repeated = images.is_repeated(field.image);
    update.report.unlit = pipeline::unlit_sectors(field.image);
    update.report.timestamp_s -= epoch_s;
    if (step.status == FieldStatus::Ok) update.T_start_robot = step.T_start_robot;
    if (step.end_of_cycle) {
        update.points = step.obstacles;
        update.ground = step.ground;
    }
    if (step.new_contacts) update.contacts = step.contacts;
    return update;
}

}  // namespace flownav::drive
