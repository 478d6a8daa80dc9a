"""The gears: from a tolerance grade to play and return error, and from numbers to teeth that mesh.

| module         | what it does                                                                    |
|----------------|---------------------------------------------------------------------------------|
| `engaged`      | what is measured on two wheels set against each other                           |
| `stage`        | what a stage is, with teeth or without: ratio, play, wheels, checks, facts      |
| `train`        | stages in a row, their play and return error (eq. 25-26)                        |
| `kinds`        | the kinds of stages: a new one is a file there and a line in its table          |
| `tooth`        | numbers of a gear -> exact curves of its teeth                                  |
| `tolerances`   | ISO 1328-1, ISO 1328-2, ISO 286: grade and size -> tolerances                   |
| `pair`         | spur gears made to a grade, and pairs of them at a centre distance              |
| `names`        | laws within a zone, orders of the stages, limits of thinning, by name           |
| `distribution` | sum of contributions free in their zones: bounds, moments, quantiles, samples   |
| `backlash`     | tolerances -> play of a pair of spur gears (eq. 1-13)                           |
| `fit_table`    | fits by name (ISO 286), light enough for every design file                      |
| `fits`         | free angle of keys and D-flats, clearance of fits (ISO 286)                     |
| `joints`       | joints and bearings as play beside the teeth's                                  |
| `chains`       | branch and bound: the cheapest chains of pairs that give a ratio                |
| `limits`       | what a searched train may be                                                    |
| `candidates`   | the stages that a search may choose from, and where they fit                    |
| `search`       | all orders of the stages; all tooth numbers that give the ratio                 |
| `blank`        | rim and blank -> a wheel's body, as a stack of prisms                           |
| `bezier`       | tooth curves as Bézier curves, for solids and files                             |
| `thinning`     | teeth as they are cut, and what thins most where none are left                  |
| `inspection`   | span and size over pins, with their limits                                      |
| `layout`       | a train's parts at their places, clear of each other and in phase               |
| `contact`      | contact ratio, by the formula and found on the tooth curves                     |
| `undercut`     | undercut and contact ratio of many pairs at once                                |
"""
