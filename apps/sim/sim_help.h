#pragma once

namespace flownav {

inline constexpr auto sim_help = R"(Records a drive through a simulated world: camera, wheels and truth.

flownav-sim WORLD.world --script STEPS --output F.rawlog
flownav-sim WORLD.world --path FILE.csv --output F.rawlog
flownav-sim --generate KIND --seed N --script STEPS --output F.rawlog [--write-world F.world]

The world
  WORLD.world              a world in Gazebo's format (SDF)
  --generate KIND          instead: a generated one, corridor, office, hall, forest, stairs or ramp
  --objects real|patterned|faint|plain   how everything but the floor looks; default: real in generated worlds,
                           else as the world says
  --floor carpet|tiles|lino|plain|stoneware|marbled   surface of the floor; default: as the world says
  --seed N                 of everything that is drawn by lot: world, noise of camera and wheels; default 1
  --write-world F.world    saves the world; without --script and --path that is all

The drive
  --script STEPS           steps from the world's start on, separated by ';':
                             forward M    back M    left DEG [RADIUS_M]    right DEG [RADIUS_M]    wait S
                             speed MPS    turn DEGPS    for the steps that follow, at most --speed, 2 x --turn-degps
                           without a radius it turns on the spot; forward and curves follow each other without a stop
  --path FILE.csv          columns time_s,x_m,y_m,yaw_rad, named in the first line; without time_s give --speed
  --speed MPS              speed of a script, or of a path without times; default 0.4
  --turn-degps D           how fast it turns on the spot, default 30

The camera
  --camera FILE.ini        its section [camera]: fx_px, ..., height_m, pitch_deg, roll_deg, forward_m, distortion
  --set camera.KEY=VALUE   sets one key, after the file; may be given several times
  --height-m H             over the ground, default 0.9
  --pitch-deg P            looking down, default 25
  --width PX, --height PX  of its images, default 640 x 480
  --fov-deg D              angle of view from left to right, where the file has no fx_px; default 55
  --rate HZ                images, or fields, per second; default 25, fields 50
  --interlaced             PAL fields of a frame of --width x --height (default 768 x 576), each of its own instant
  --noise GREY             standard deviation of its noise in grey levels, default 2.5
  --vibration-deg D        standard deviation of its pitch, default 0
  --exposure-step S        share by which its exposure steps every 12 to 24 images, default 0
  --vignetting S           share of light lost in the corners, default 0
  --blur-px PX             sigma of the lens, default 0

The wheels
  --wheel-scale S          distances they measure over true ones, default 1.006
  --wheel-turn-scale S     turns they measure over true ones, default 1.01
  --wheel-noise F          factor on their noise of 1 mm and 2 mrad after 1 m; 0: none

Output
  --output F.rawlog        CAMERA1, ODOMETRY, GROUND_TRUTH, for flownav-replay; it appears when it is complete
  --quiet                  no progress and no closing line
  --help, --version        print this text, or the version, and exit

Exit status:
  0  fine
  1  bad usage or configuration; nothing was written
  2  a world or a path could not be read; nothing was written
  3  output could not be written
)";

}  // namespace flownav
