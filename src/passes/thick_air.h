// The light in air so thick that it is scattered hundreds of times: the fixed point
//   x = b + K x
// of the source table, b the light scattered or reflected once and K one order more, found in a few
// steps instead of as many orders.
//
// What x lacks is told by diffusion: r = b + K x - x and the multiple scattering of r (diffusion
// synthetic acceleration: Adams & Larsen 2002, Prog. Nucl. Energy 40, 3; the P1 equations over
// height and the Sun's zenith angle, in a spherical shell with Marshak's condition at its top and
// the ground's albedo below). Each step adds such a multiple of it, made conjugate to the steps
// before, that it becomes least (generalised conjugate residuals: Eisenstat, Elman & Schultz 1983,
// SIAM J. Numer. Anal. 20, 345). What is found is the tables' own fixed point: the diffusion only
// leads there.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "passes/air_tables.h"

namespace antumbra {

// What the solver knows of the air, by wavelength (as many as four times the layers).
struct ThickAirGrid {
  int width = 0, height = 0;  // cells: Sun's zenith angles, heights
  int slices = 0;             // of a layer: harmonics, irradiance
  Length groundRadius;
  std::vector<double> heights;     // of the rows, m, ascending
  std::vector<double> sunCosines;  // of the columns
  std::vector<double> groundAlbedo;
  // Over the fine heights i / (fine - 1) between a row and the next: 1/m, without forward peaks.
  // extinction[wavelength][row * fine + i], scattering and scattering times mean cosine likewise.
  int fine = 0;
  std::vector<std::vector<double>> extinction, scattering, turned;
};

// `order` and `phases`: of the tables (passes/air_tables.h). `heights`, `sunCosines`: of the cells.
ThickAirGrid thickAirGrid(const Medium& medium, const std::vector<std::size_t>& order,
                          const AirPhases& phases, const std::vector<Length>& wavelengths,
                          Length groundRadius, std::vector<double> heights,
                          std::vector<double> sunCosines, int slices);

class ThickAirSolver {
 public:
  // `once`: b, as the source table is read: slices of layers, rows, columns, four wavelengths.
  ThickAirSolver(ThickAirGrid grid, std::vector<float> once);
  ~ThickAirSolver();
  // The next direction z, of which K z is asked for.
  const std::vector<float>& direction();
  void advance(const std::vector<float>& scattered);  // K z
  const std::vector<float>& light() const { return light_; }
  // What x still lacks of its mean radiance, over that: root mean square over all cells, of the
  // wavelength that lacks most.
  double change() const;

 private:
  struct Diffusion;
  struct Step {
    std::vector<float> to, gain;  // z; what it gives: z - K z with its diffusion
    std::vector<double> square;   // of the gain, by wavelength
  };
  std::size_t at(int wavelength, int slice, int row, int column) const;
  // Adds what the diffusion makes of it.
  void diffuse(int wavelength, std::vector<float>& light) const;
  double product(int wavelength, const std::vector<float>& a, const std::vector<float>& b) const;

  ThickAirGrid grid_;
  std::vector<float> light_, lacking_;
  std::vector<Diffusion> diffusions_;        // by wavelength
  std::vector<std::vector<double>> scales_;  // and by cell: 1 / brightness
  std::vector<Step> steps_;
};

}  // namespace antumbra
