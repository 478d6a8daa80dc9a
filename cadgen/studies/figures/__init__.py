"""Figures of a design that a study may aim at or limit. A new one is a file in this folder and a name in `table`.

| module           | what it holds                                                               |
|------------------|-----------------------------------------------------------------------------|
| `figure`         | a figure: code with unit, direction, function                                |
| `evaluated`      | a design with everything that its figures are computed from, when needed     |
| `table`          | every figure by its code                                                     |
| `drift`          | end of the run by play, to first order; cheap                                |
| `return_error`   | return error of the train; cheap                                             |
| `worst_end`      | worst end of the run over the band of play, by the exact chain               |
| `disc_diameter`  | diameter of the circle about the disc                                        |
| `disc_mass`      | mass of the disc                                                             |
| `holding_energy` | energy that the drag takes which holds the cam                               |
| `cutting_time`   | time that the programs for the mill move at a feed                           |
| `passed`         | share of random cars that keep the course                                    |
"""
