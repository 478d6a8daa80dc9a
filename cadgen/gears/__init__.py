"""Gears: from a tolerance grade to play and return error, and from numbers to teeth that mesh.

| module            | what it does                                                                          |
|-------------------|---------------------------------------------------------------------------------------|
| `choices`         | distributions within a zone, orders of the stages, limits of thinning, by name        |
| `tooth`           | numbers of a gear -> exact curves of its teeth                                        |
| `ring`            | numbers of an internal gear -> exact curves of its teeth; its pinion cutter           |
| `internal`        | reserves of internal pairs, and how long a ring's tips may be                         |
| `tolerances`      | ISO 1328-1, ISO 1328-2, ISO 286: grade and size -> tolerances                         |
| `flank_tolerances` | ISO 1328-1:2013: flank tolerances by class, and the class a deviation reaches        |
| `fits`            | fits by name (ISO 286), free angle of keys and D-flats                                |
| `distribution`    | sum of contributions free in their zones: bounds, moments, quantiles, samples         |
| `stage`           | what a stage is, with teeth or without: ratio, play, wheels, checks, facts            |
| `pair`            | cylindrical gears made to a grade, and pairs of them at a centre distance             |
| `backlash`        | tolerances -> play of a pair of gears (eq. 1-13), and teeth thinned for it            |
| `contact`         | contact ratio and undercut, by the formulas and found on the tooth curves             |
| `sliding`      | specific sliding and losses of the teeth                                        |
| `shifts`       | profile shifts proposed for a pair: no undercut, balanced sliding               |
| `inspection`      | span and size over pins, with their limits                                            |
| `spur`            | pairs of cylindrical gears as a stage: their checks in mesh, and their plain values   |
| `rack`            | numbers of a rack -> its section; a pinion on it                                      |
| `planetary`       | sun, planets and ring: where planets fit, signed ratio, play at the output            |
| `planetary_stage` | planetary sets as a stage: carrier and planets as bodies, play of planets that differ |
| `planetary_kind`  | the kind of planetary stages: their keys                                              |
| `rack_stage`      | pinion and rack as the last stage: play, travel, place of the bar                     |
| `rack_kind`       | the kind of rack stages: their keys                                                   |
| `stage_kind`      | kind of a stage: its code, its keys, and how the stage is built                       |
| `stage_kinds`     | the table of kinds of stages: a new one is a file beside `spur` and a line there      |
| `train`           | stages in a row, their play and return error (eq. 25-26); joints and bearings         |
| `chains`          | branch and bound: the cheapest chains of pairs that give a ratio                      |
| `tools`           | tools that cut teeth: what they cannot reach, and the room that they need             |
| `wheel_body`      | rim and blank -> a wheel's body, as a stack of prisms                                 |
| `layout`          | a train's parts at their places, clear of each other and in phase                     |
| `cutting`         | how each part of a train is made: its checks and notes                                |
| `synthesis`       | all orders of the stages; all tooth numbers that give the ratio                       |
"""
