#include "corruptions.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/system/datetime.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/math/units.h"

namespace flownav::bench {
namespace {

using mrpt::obs::CObservation;
using mrpt::obs::CObservationImage;
using mrpt::obs::CObservationOdometry;

double uniform(Dice& dice, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(dice);
}
std::size_t any(Dice& dice, std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(dice);
}
bool coin(Dice& dice) {
    return any(dice, 2) == 0;
}
/// A factor that is plainly not 1.
double factor(Dice& dice) {
    const double much = uniform(dice, 1.1, 2.0);
    return coin(dice) ? much : 1.0 / much;
}
double either_sign(Dice& dice, double low, double high) {
    return (coin(dice) ? 1 : -1) * uniform(dice, low, high);
}

double time_of(const CObservation& observation) {
    return mrpt::Clock::toDouble(observation.timestamp);
}
void set_time(CObservation& observation, double time_s) {
    observation.timestamp = mrpt::Clock::fromDouble(time_s);
}

template <class Class>
std::vector<Class*> all(const Recording& recording) {
    std::vector<Class*> found;
    for (const auto& observation : recording)
        if (auto* one = dynamic_cast<Class*>(observation.get())) found.push_back(one);
    return found;
}

template <class Class>
using Change = std::function<void(std::vector<Class*>&, Dice&)>;

/// A change of all observations of a class.
template <class Class>
Corruption of(const std::string& name, Change<Class> change) {
    return {name, [change](Recording& recording, Dice& dice) {
                auto found = all<Class>(recording);
                if (found.size() > 4) change(found, dice);
            }};
}

template <class Class>
void shift_one(std::vector<Class*>& list, Dice& dice, double low_s, double high_s) {
    Class& one = *list[any(dice, list.size())];
    set_time(one, time_of(one) + either_sign(dice, low_s, high_s));
}

template <class Class>
void shift_from(std::vector<Class*>& list, Dice& dice, double shift_s) {
    for (std::size_t i = 2 + any(dice, list.size() - 3); i < list.size(); ++i)
        set_time(*list[i], time_of(*list[i]) + shift_s);
}

template <class Class>
void scale_times(std::vector<Class*>& list, double by) {
    const double first_s = time_of(*list.front());
    for (Class* one : list) set_time(*one, first_s + by * (time_of(*one) - first_s));
}

template <class Class>
std::vector<Corruption> time_corruptions(const std::string& what) {
    const auto made = [&what](const char* name, Change<Class> change) {
        return of<Class>(what + ": " + name, std::move(change));
    };
    return {
        made("one stamp up to two periods off",
             [](auto& list, Dice& dice) { shift_one<Class>(list, dice, 0.01, 0.16); }),
        made("one stamp a day off", [](auto& list, Dice& dice) { shift_one<Class>(list, dice, 8e4, 9e4); }),
        made("all stamps shifted",
             [](auto& list, Dice& dice) {
                 const double shift_s = either_sign(dice, 0.3, coin(dice) ? 3.0 : 1e5);
                 for (Class* one : list) set_time(*one, time_of(*one) + shift_s);
             }),
        made("stamps scaled", [](auto& list, Dice& dice) { scale_times<Class>(list, factor(dice)); }),
        made("stamps in milliseconds", [](auto& list, Dice&) { scale_times<Class>(list, 1e3); }),
        made("stamps a thousandth", [](auto& list, Dice&) { scale_times<Class>(list, 1e-3); }),
        made("stamps repeated",
             [](auto& list, Dice& dice) {
                 const std::size_t every = 2 + any(dice, 6);
                 for (std::size_t i = 1; i < list.size(); i += every)
                     list[i]->timestamp = list[i - 1]->timestamp;
             }),
        made("stamps of neighbours exchanged",
             [](auto& list, Dice& dice) {
                 const std::size_t every = 2 + any(dice, 6);
                 for (std::size_t i = 1; i < list.size(); i += every)
                     std::swap(list[i]->timestamp, list[i - 1]->timestamp);
             }),
        made("clock set back",
             [](auto& list, Dice& dice) { shift_from<Class>(list, dice, -uniform(dice, 1, 5e4)); }),
        made("clock set ahead",
             [](auto& list, Dice& dice) { shift_from<Class>(list, dice, uniform(dice, 5, 5e4)); }),
        made("stamps of whole seconds",
             [](auto& list, Dice&) {
                 for (Class* one : list) set_time(*one, std::floor(time_of(*one)));
             }),
        made("stamps in pairs",
             [](auto& list, Dice&) {
                 for (std::size_t i = 1; i < list.size(); i += 2)
                     set_time(*list[i], time_of(*list[i - 1]) + 0.001);
             }),
        made("stamps missing",
             [](auto& list, Dice& dice) {
                 for (Class* one : list)
                     if (any(dice, 4) == 0) one->timestamp = INVALID_TIMESTAMP;
             }),
        made("stamps before 1970",
             [](auto& list, Dice&) {
                 for (Class* one : list) set_time(*one, time_of(*one) - 1.9e9);
             }),
    };
}

/// Drops images, but not the first and the last ones: what was before or after them nobody can know.
void erase_some(Recording& recording, Dice& dice) {
    const double share = uniform(dice, 0.05, 0.3);
    const auto is_image = [](const CObservation::Ptr& one) {
        return dynamic_cast<CObservationImage*>(one.get()) != nullptr;
    };
    constexpr int kept = 3;
    const auto images = std::count_if(recording.begin(), recording.end(), is_image);
    int number = 0;
    const auto falls_out = [&](const CObservation::Ptr& one) {
        if (!is_image(one)) return false;
        ++number;
        return number > kept && number <= images - kept && uniform(dice, 0, 1) < share;
    };
    recording.erase(std::remove_if(recording.begin(), recording.end(), falls_out), recording.end());
}

/// Replaces the pixels of every image.
void repaint(std::vector<CObservationImage*>& images, const std::function<cv::Mat(const cv::Mat&)>& change) {
    for (CObservationImage* image : images)
        image->image = mrpt::img::CImage(change(image->image.asCvMatRef()), mrpt::img::DEEP_COPY);
}

void turn_mount(CObservationImage& image, double yaw_rad, double pitch_rad, double roll_rad) {
    const mrpt::poses::CPose3D optical(0, 0, 0, -M_PI / 2, 0, -M_PI / 2);
    const mrpt::poses::CPose3D level = image.cameraPose + (mrpt::poses::CPose3D() - optical);
    image.cameraPose = mrpt::poses::CPose3D(level.x(), level.y(), level.z(), level.yaw() + yaw_rad,
                                            level.pitch() + pitch_rad, level.roll() + roll_rad) +
                       optical;
}

void scale_focus(std::vector<CObservationImage*>& images, double focus, double centre) {
    for (CObservationImage* image : images) {
        auto& c = image->cameraParams;
        c.setIntrinsicParamsFromValues(focus * c.fx(), focus * c.fy(), centre * c.cx(), centre * c.cy());
    }
}

using Images = std::vector<CObservationImage*>;

Corruption of_images(const std::string& name, Change<CObservationImage> change) {
    return of<CObservationImage>(name, std::move(change));
}

std::vector<Corruption> pose_corruptions() {
    const auto turned = [](double low_deg, double high_deg, int axis) {
        return [=](Images& images, Dice& dice) {
            const double angle_rad = either_sign(dice, low_deg, high_deg) * degree_rad;
            for (CObservationImage* image : images)
                turn_mount(*image, axis == 0 ? angle_rad : 0, axis == 1 ? angle_rad : 0,
                           axis == 2 ? angle_rad : 0);
        };
    };
    return {
        of_images("pose: height",
                  [](Images& images, Dice& dice) {
                      const double by = factor(dice);
                      for (CObservationImage* image : images) image->cameraPose.z(by * image->cameraPose.z());
                  }),
        of_images("pose: height in centimetres",
                  [](Images& images, Dice&) {
                      for (CObservationImage* image : images)
                          image->cameraPose.z(100 * image->cameraPose.z());
                  }),
        of_images("pose: pitch", turned(3, 20, 1)),
        of_images("pose: roll", turned(3, 12, 2)),
        of_images("pose: yaw", turned(3, 12, 0)),
        of_images("pose: x forward",
                  [](Images& images, Dice&) {
                      for (CObservationImage* image : images)
                          image->cameraPose =
                              image->cameraPose + (mrpt::poses::CPose3D() -
                                                   mrpt::poses::CPose3D(0, 0, 0, -M_PI / 2, 0, -M_PI / 2));
                  }),
        of_images("pose: rolled by 180", turned(180, 180, 2)),
        of_images("pose: none",
                  [](Images& images, Dice&) {
                      for (CObservationImage* image : images) image->cameraPose = {};
                  }),
    };
}

std::vector<Corruption> calibration_corruptions() {
    return {
        of_images("calibration: focal length",
                  [](Images& images, Dice& dice) { scale_focus(images, factor(dice), 1.0); }),
        of_images("calibration: of another size, undeclared",
                  [](Images& images, Dice& dice) {
                      const double by = coin(dice) ? 2.0 : 0.5;
                      scale_focus(images, by, by);
                  }),
        of_images("calibration: of another size, declared",
                  [](Images& images, Dice& dice) {
                      const unsigned by = 2 + static_cast<unsigned>(any(dice, 3));
                      scale_focus(images, by, by);
                      for (CObservationImage* image : images) {
                          image->cameraParams.ncols *= by;
                          image->cameraParams.nrows *= by;
                      }
                  }),
        of_images("calibration: of another shape",
                  [](Images& images, Dice&) {
                      scale_focus(images, 2, 2);
                      for (CObservationImage* image : images) {
                          image->cameraParams.ncols *= 2;
                          image->cameraParams.nrows = image->cameraParams.ncols * 9 / 16;
                      }
                  }),
        of_images("calibration: shares of the size",
                  [](Images& images, Dice&) { scale_focus(images, 1.0 / 320, 1.0 / 320); }),
        of_images("calibration: axes exchanged",
                  [](Images& images, Dice&) {
                      for (CObservationImage* image : images) {
                          auto& c = image->cameraParams;
                          c.setIntrinsicParamsFromValues(c.fy(), c.fx(), c.cy(), c.cx());
                      }
                  }),
        of_images("calibration: none",
                  [](Images& images, Dice&) {
                      for (CObservationImage* image : images) image->cameraParams = {};
                  }),
        of_images("image: half the size",
                  [](Images& images, Dice&) {
                      repaint(images, [](const cv::Mat& from) {
                          cv::Mat half;
                          cv::resize(from, half, {}, 0.5, 0.5, cv::INTER_AREA);
                          return half;
                      });
                  }),
        of_images("image: upside down",
                  [](Images& images, Dice&) {
                      repaint(images, [](const cv::Mat& from) {
                          cv::Mat turned;
                          cv::rotate(from, turned, cv::ROTATE_180);
                          return turned;
                      });
                  }),
        of_images("image: mirrored",
                  [](Images& images, Dice&) {
                      repaint(images, [](const cv::Mat& from) {
                          cv::Mat mirrored;
                          cv::flip(from, mirrored, 1);
                          return mirrored;
                      });
                  }),
        of_images("image: mirrored up and down",
                  [](Images& images, Dice&) {
                      repaint(images, [](const cv::Mat& from) {
                          cv::Mat mirrored;
                          cv::flip(from, mirrored, 0);
                          return mirrored;
                      });
                  }),
        of_images("image: turned by 90 degrees",
                  [](Images& images, Dice&) {
                      repaint(images, [](const cv::Mat& from) {
                          cv::Mat turned;
                          cv::rotate(from, turned, cv::ROTATE_90_CLOCKWISE);
                          return turned;
                      });
                  }),
    };
}

using Wheels = std::vector<CObservationOdometry*>;

void scale_odometry(Wheels& wheels, double way, double turn) {
    for (CObservationOdometry* one : wheels) {
        const auto& p = one->odometry;
        one->odometry = mrpt::poses::CPose2D(way * p.x(), way * p.y(), turn * p.phi());
    }
}

std::vector<Corruption> odometry_corruptions() {
    const auto made = [](const char* name, Change<CObservationOdometry> change) {
        return of<CObservationOdometry>(std::string("odometry: ") + name, std::move(change));
    };
    return {
        made("scaled",
             [](Wheels& wheels, Dice& dice) {
                 const double by = factor(dice);
                 scale_odometry(wheels, by, by);
             }),
        made("negated", [](Wheels& wheels, Dice&) { scale_odometry(wheels, -1, -1); }),
        made("turns negated", [](Wheels& wheels, Dice&) { scale_odometry(wheels, 1, -1); }),
        made("in millimetres", [](Wheels& wheels, Dice&) { scale_odometry(wheels, 1000, 1); }),
        made("starts far off",
             [](Wheels& wheels, Dice&) {
                 for (CObservationOdometry* one : wheels)
                     one->odometry = mrpt::poses::CPose2D(4e6, -4e6, 2.0) + one->odometry;
             }),
        made("reset on the way",
             [](Wheels& wheels, Dice& dice) {
                 const std::size_t from = 2 + any(dice, wheels.size() - 3);
                 const mrpt::poses::CPose2D origin = wheels[from]->odometry;
                 for (std::size_t i = from; i < wheels.size(); ++i)
                     wheels[i]->odometry = wheels[i]->odometry - origin;
             }),
        made("stands still", [](Wheels& wheels, Dice&) { scale_odometry(wheels, 0, 0); }),
        made("label",
             [](Wheels& wheels, Dice&) {
                 for (CObservationOdometry* one : wheels) one->sensorLabel = "odom";
             }),
    };
}

}  // namespace

Recording copy_of(const Recording& recording) {
    Recording copy;
    for (const auto& observation : recording)
        copy.push_back(std::dynamic_pointer_cast<CObservation>(observation->duplicateGetSmartPtr()));
    return copy;
}

const std::vector<Corruption>& corruptions() {
    static const std::vector<Corruption> list = [] {
        std::vector<Corruption> all = {
            {"images dropped", erase_some},
            of_images("image: label",
                      [](Images& images, Dice&) {
                          for (CObservationImage* image : images) image->sensorLabel = "front";
                      }),
        };
        for (const auto& more : {time_corruptions<CObservationImage>("image times"),
                                 time_corruptions<CObservationOdometry>("odometry times"), pose_corruptions(),
                                 calibration_corruptions(), odometry_corruptions()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return list;
}

}  // namespace flownav::bench
