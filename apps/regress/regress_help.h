#pragma once

namespace flownav {

inline constexpr auto regress_help =
    R"(Replays many rawlogs as one, and tells what a change of the code or of a parameter does to them.

flownav-regress manifest DIR [--output FILE]
flownav-regress run --manifest FILE --output DIR [--config FILE.ini] [--set section.key=value]...
flownav-regress merge --manifest FILE --output DIR [--missing] [--failed]
flownav-regress check --manifest FILE --output DIR [--expected FILE.json] [--junit FILE.xml] [--any-version]
flownav-regress accept --manifest FILE --output DIR [--expected FILE.json]
flownav-regress compare DIR_A DIR_B [--output FILE.html]
flownav-regress sweep --manifest FILE --output DIR --set section.key=a,b,c [--set ...]...

manifest   prints a line for every rawlog below DIR: identifier, path, sha256, apart by tabs
run        replays every rawlog of the manifest that is not in DIR/done yet; without a shard it merges at the end
merge      writes DIR/merged.json and DIR/merged.csv from DIR/done and DIR/failed, in the order of the manifest
check      compares the figures of a run with those expected: which moved out of tolerance, whither, by how much
accept     makes the figures of a run the expected ones, and shows what that changes
compare    every figure of two runs side by side, the worst first, and a page with ways, maps and curves of both
sweep      run for every combination of the values; writes DIR/sweep.csv and DIR/sweep.html

Which rawlogs
  --manifest FILE           text, a line a rawlog: identifier, path, sha256, then any number of settings:
                            config=FILE.ini or section.key=value. Apart by tabs, or by blanks where there are none.
                            '#' begins a comment
  --root DIR                what relative paths of the manifest start from; default: the manifest's folder
  --shard I --shards N      only line k with k mod N = I, both counted from 0. Else I is the first that is set of
                            SHARD_INDEX, SLURM_ARRAY_TASK_ID, JOB_COMPLETION_INDEX, AWS_BATCH_JOB_ARRAY_INDEX, and
                            N is SHARD_COUNT

How they are replayed
  --output DIR              results, a folder a rawlog: DIR/done/ID, DIR/failed/ID
  --config, --set           as flownav-replay takes them; a manifest's own settings come after --config, before --set
  --program FILE            the flownav-replay to use; default: the one beside this program, else that of PATH
  --time-limit S            a replay that takes longer is ended and counts as failed; default 1800
  --jobs N                  replays at the same time; default: one a processor, with a shard 1
  --keep all|figures        of each replay all files, or only its figures; default all, of a sweep figures
  --force                   replay also what is done
  --quiet                   no progress

Checking
  --expected FILE.json      default: expected.json beside the manifest
  --junit FILE.xml          the same for a CI server, a test case a rawlog
  --any-version             compare although the expectation was made by another version
  --missing, --failed       print the lines without a result, with a failed one: 3,17,20 for sbatch --array=

  --help, --version         print this text, or the version, and exit

Exit status:
  0    fine
  1    a replay failed, or a comparison did
  2    bad usage, configuration, manifest or expectation; nothing was replayed
  3    merge: a rawlog is missing or failed
  75   results could not be written; try again
  130  ended by SIGINT, 143 by SIGTERM; nothing is half written, the next run goes on from there
share/doc/regression.md explains all of it by example.
)";

}  // namespace flownav
