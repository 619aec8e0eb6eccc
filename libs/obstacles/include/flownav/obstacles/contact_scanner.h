#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "flownav/core/contact_scan.h"
#include "flownav/obstacles/cone_scan.h"
#include "flownav/obstacles/contact_params.h"
#include "flownav/obstacles/contact_votes.h"
#include "flownav/obstacles/floor_registration.h"

namespace flownav::obstacles {

/// The end of a cycle: the newest image and where the camera has got to.
struct CycleEnd {
    const ImageView& image;
    const RayMapper& mapper;  ///< of the image's camera
    Pose2 T_start_robot;
    double pitch_rad = 0.0;  ///< sum of all pitch since the start
    double way_error = 1.0;  ///< relative standard error of the travel of this cycle
    bool way_known = false;  ///< the travel of this cycle was measured, by flow or by the wheels
};

/// A level image that scans look back to.
struct KeyImage {
    LevelImage image;
    Pose2 T_start_robot;
    double pitch_rad = 0.0;
};

/// The last key images. Slot 0 is the newest.
class KeyImages {
  public:
    static constexpr int most = 7;

    KeyImage& operator[](int i) { return images_[static_cast<std::size_t>((newest_ + i) % most)]; }
    const KeyImage& operator[](int i) const {
        return images_[static_cast<std::size_t>((newest_ + i) % most)];
    }
    int size() const { return size_; }
    /// Makes room for a new one at slot 0; the oldest is lost when there are `most`.
    KeyImage& push() {
        newest_ = (newest_ + most - 1) % most;
        size_ = size_ < most ? size_ + 1 : most;
        return (*this)[0];
    }
    void reserve(std::size_t pixels) {
        for (KeyImage& key : images_) key.image.grey.reserve(pixels);
    }
    /// Keeps the newest `count`.
    void keep(int count) { size_ = count < size_ ? count : size_; }

  private:
    std::array<KeyImage, most> images_;
    int newest_ = 0;
    int size_ = 0;
};

/// A place that showed a contact in an earlier scan, in the frame of T_start_robot.
struct EarlierContact {
    Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d robot_m = Eigen::Vector2d::Zero();  ///< where the robot was
    int scan = 0;
};

/// What one strip of one scan shows, before earlier scans are asked.
struct StripEvidence {
    Contact votes;
    double floor_end_m = 0.0;   ///< floor is confirmed from the lower border of the image up to here
    double wall_m = 0.0;        ///< foot of a surface without edges, see find_walls(); 0: none
    bool is_seen = false;       ///< its near floor was compared
    double first_edge_m = 0.0;  ///< memory of the wall rule
};

/// Motion of a pair of key images by odometry, and the same with the floor registered.
struct FittedPair {
    PairMotion measured;
    PairMotion fitted;
    PairWarp warp;
};

/// The parts of a scan, in their order. Each takes about as long as the others.
enum class ScanPart { None, Register, Compare, Vote, CompareAhead, VoteAhead };

/// A scan that is under way.
struct ScanInWork {
    ScanPart next = ScanPart::None;
    double way_error = 1.0;  ///< of the cycle
    CameraMount mount;
    FittedPair pair;
    double vignetting = 0.0;  ///< as this scan measured it
    double noise = 0.0;
    int ahead = 0;  ///< key image of the long pair; 0: none
    ContactScan scan;
};

/// Where the floor of a strip ends.
struct FloorEnd {
    double forward_m = 0.0;   ///< 0: no floor is confirmed
    int cell = 0;             ///< the last one of floor
    bool of_texture = false;  ///< texture ends there as well
};

/// Where a scan sees floor.
struct FloorMap {
    std::vector<char> floor;      ///< of each cell
    std::vector<FloorEnd> ends;   ///< of each strip
    std::vector<double> sorted;   ///< buffer
    std::vector<double> missing;  ///< of each group of rows: -log of the chance to see no floor where it is
};

/// Memory of the scan from cycle to cycle.
struct ContactMemory {
    LevelMapping mapping;
    KeyImages keys;
    double vignetting = 0.0;  ///< learnt fall-off of brightness at the corner of the image
    double noise = 1.2;       ///< learnt standard deviation of differences of grey levels
    int scans = 0;
    std::vector<EarlierContact> earlier;
    ConeMemory cone;
    ScanInWork work;

    // Buffers.
    FloorComparison comparison;
    ContactVotes votes;
    RegistrationScratch registration;
    std::vector<StripEvidence> evidence;
    FloorMap floor;
};

/// Forgets everything; `mapper` is that of the images to come.
void restart(ContactMemory& memory, const RayMapper& mapper);

/// Forgets the images: the way between those before and those to come is unknown.
void forget_images(ContactMemory& memory);

/// Begins the scan of a cycle when the robot has travelled far enough since the last one; true when it did.
/// The scan under way must be finished first. It speaks of the robot frame of this image.
bool begin_scan(ContactMemory& memory, const CycleEnd& cycle, const ContactParams& params);

/// True between begin_scan() and the last part of that scan.
bool is_scanning(const ContactMemory& memory);

/// Does the next part of the scan under way, so that its parts may be spread over the fields of a cycle; true
/// when it was the last one and `out` is the scan. out.gate says whether the cycle could be scanned.
bool continue_scan(ContactMemory& memory, const ContactParams& params, ContactScan& out);

/// Scans a cycle in one go; true when `out` is new.
bool scan_cycle(ContactMemory& memory, const CycleEnd& cycle, const ContactParams& params, ContactScan& out);

/// Motion of the camera between two key images by odometry.
PairMotion pair_motion(const KeyImage& reference, const KeyImage& newer, const CameraMount& mount);

}  // namespace flownav::obstacles
