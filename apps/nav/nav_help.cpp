#include "nav_options.h"

namespace flownav {

const char* const nav_help = R"(Drives a robot to its goal with one camera.

flownav-nav --robot sim (--world FILE.world | --generate KIND) [--goal X,Y] [options]
flownav-nav --robot tcp:HOST:PORT --camera CAM.ini --goal X,Y [options]

The robot and where it goes
  --robot sim              the simulated robot (default)
  --robot tcp:HOST:PORT    a real one, behind the lines that share/doc/robot.md explains
  --camera CAM.ini         its camera: a section of rawlog-grabber's with driver = CFlowObstacleSensor. Its
                           keys hold before --config and --set. A rawlog, a folder or a video plays a recording
  --world FILE.world       a world for it, in Gazebo's format (SDF)
  --generate KIND          a generated world: corridor, office, hall, forest, stairs or ramp; --seed picks one
  --start X,Y,YAW_DEG      where it starts; default: as the world says, or 0,0,0
  --goal X,Y               where it is to go, in the world's frame (m); default: as the world says
  --waypoints FILE         a text file of way points on the way there, x y on each line
  --follow X,Y             instead of a goal: follow a way point fixed in the robot's own frame, ...
  --way-max-m M            ... and stop after so much way
  --success-radius-m M     reached when this near to the goal in truth, default 0.5
  --timeout-s S            give up after so much time, default 120

How it drives
  --navigator lanes|reactive   circular lanes, or MRPT's reactive navigation; as navigation.navigator
  --sensor flow|lidar      the camera (default), or an ideal lidar to compare with
  --config FILE.ini        configuration; flownav-config --doc --keys everyday|all lists the keys, [navigation]
                           has the robot, [guard] what stops it
  --set section.key=value  sets one key, after the file; may be given several times
  --seed N                 of everything that is drawn by lot: world, textures, noise; default 1

The simulated camera; its height, pitch and place are camera.height_m, camera.pitch_deg, ...
  --width PX, --height PX  of its images, default 640 x 480
  --interlaced             PAL fields of a frame of --width x --height (default 768 x 576), 50 a second
  --fov-deg D              angle of view from left to right, default 90
  --rate HZ                images per second, default 25
  --noise GREY             standard deviation of its noise, default 2
  --vibration-deg D        standard deviation of its pitch, default 0
  --supersampling N        samples a pixel in either direction, 1..4, default 2; 1 takes a third of the time
  --objects real|patterned|faint|plain   how everything but the floor looks; default: real in generated worlds,
                           else as the world says
  --floor carpet|tiles|lino|plain|stoneware|marbled   surface of the floor; default: as the world says

What is kept
  --output DIR             everything about the drive, of a real robot too: result.json, drive.png, drive.csv,
                           the recording run.rawlog, and what flownav-replay makes of it, with report.html
  --result FILE.json       outcome, time, way, clearance, stops with their reasons
  --record FILE.rawlog     the camera's fields, odometry and ground truth, for flownav-replay
  --picture FILE.png       map, way and truth seen from above
  --navlog DIR             logs for MRPT's navlog-viewer
  --reference-path-m M     length of the best way: adds BARN's score to the result
  --realtime               not faster than the clock
  --quiet                  neither progress nor a closing line
  --help, --version        print this text, or the version, and exit

Exit status:
  0  the goal was reached
  1  bad usage or configuration; nothing was written
  2  a world or a list of way points could not be read, or robot or camera were lost
  3  output could not be written
  4  blocked: no way was found        5  something was touched, or the robot fell    6  the time was over
  7  stopped by SIGINT, SIGTERM or SIGHUP
When a drive ends, however it ends, the robot is told to stop and what was recorded is written.
)";

}  // namespace flownav
