"""One job from a design to verified files; the command line and other programs call these.

| module  | what it does                                                         |
|---------|----------------------------------------------------------------------|
| `cam`   | design -> lift, profile and checks; cures for what fails             |
| `edges` | what edges broken more than designed cost at the finish              |
| `as_built` | what a design says of the car as built, in words and values       |
| `files` | a checked cam -> every file, read back, rolled, published, on record |
| `gears` | design -> play, order, layout and measured mesh of the gear train    |
| `gears_checks` | a train laid out -> its teeth and bodies measured, with verdicts |
| `gears_facts` | a planned train -> plain values for manifest, table and machines |
| `gears_files` | a checked train -> every file, read back, measured, on record  |
"""
