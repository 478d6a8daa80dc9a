"""Frame of a car: two bearing plates, a base, the fork's platform and block, and brackets, by the layout.

| module            | what it holds                                                                    |
|-------------------|----------------------------------------------------------------------------------|
| `frame_sizes`     | sizes that a design states                                                       |
| `frame_ground`    | heights of base, platform and block; openings of the base; screws in edges       |
| `fork_block`      | bearing block of the fork's spindle, and its platform                            |
| `foot_joints`     | joints of standing sheets with the base: tabs in slots, and screws from below    |
| `standing_sheets` | bearing plates and brackets, with what they need of the base                     |
| `base_plate`      | base: openings, slots, holes, and weight or motor on it                          |
| `one_piece`       | base and standing sheets as one printed part, with the bridges of its walls      |
| `bought_parts`    | bearings, screws, nuts, spacers, and what guides a weight                        |
| `built_frame`     | parts at their places, and what they come to                                     |
| `frame_maker`     | the frame of a layout, its base lowered until all that stands on it has room     |
| `frame_gaps`      | gaps of the frame to what moves, and among its parts                             |

The base lies under the seats of all bearings, as high as these allow; gears that reach lower, and the front wheel, pass
through openings in it. The sheets that stand on it have tabs in slots of the base, and screws from below. A platform on
spacers carries the block that bears the fork. Its slots along the car let a micrometer head in a bracket before it set
the distance between fork axis and camshaft.

A frame that is printed has the same shapes without tabs, slots and screws from below: base, plates and brackets are one
part. Its lower face lies on the printer's bed, and the sheets are its walls.
"""
