// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/csv_file.h>
#include <seiche/scene/surface_file.h>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr std::uintmax_t largest_surface = 1u << 30;

    constexpr std::array<const char *, 4> formats = {
      {".stl", ".obj", ".ply", ".off"}};

    bool
    is_known(const std::string &filename)
    {
      std::string ending = std::filesystem::path(filename).extension();
      for (char &letter : ending)
        letter = std::tolower(static_cast<unsigned char>(letter));
      return std::count(formats.begin(), formats.end(), ending) > 0;
    }

    /// Files repeat a vertex for each of its triangles, digit by digit.
    class SurfaceBuilder
    {
    public:
      void
      add(const aiMesh &mesh)
      {
        for (unsigned int f = 0; f < mesh.mNumFaces; ++f)
          {
            const aiFace &face = mesh.mFaces[f];
            if (face.mNumIndices != 3) // points and lines
              continue;
            TriangleSurface::Triangle triangle;
            for (unsigned int c = 0; c < 3; ++c)
              triangle[c] = number(mesh.mVertices[face.mIndices[c]]);
            if (triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
                triangle[2] != triangle[0])
              surface.triangles.push_back(triangle);
          }
      }

      TriangleSurface surface;
      bool            is_finite = true;

    private:
      unsigned int
      number(aiVector3D x)
      {
        if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z))
          {
            is_finite = false;
            x         = aiVector3D(); // no key is not a number
          }
        const auto [known, is_new] =
          numbers.emplace(std::array<double, 3>{{x.x, x.y, x.z}},
                          surface.vertices.size());
        if (is_new)
          surface.vertices.emplace_back(x.x, x.y, x.z);
        return known->second;
      }

      std::map<std::array<double, 3>, unsigned int> numbers;
    };

    /// InputError if single precision, which assimp has, spoils the shape.
    void
    require_digits(const InputFile       &input,
                   const std::string     &path,
                   const std::string     &filename,
                   const TriangleSurface &surface)
    {
      constexpr double needed   = 1e-4; // of the size
      double           farthest = 0., size = 0.;
      for (const Point<3> &x : surface.vertices)
        {
          farthest = std::max(farthest, x.norm());
          size     = std::max(size, x.distance(surface.vertices[0]));
        }
      input.require(farthest * std::numeric_limits<float>::epsilon() <=
                      needed * size,
                    path,
                    filename + ": so far from the origin the coordinates, "
                               "which are read with 7 digits, do not tell the "
                               "shape; move the body there, and Shift it.");
    }
  } // namespace

  TriangleSurface
  read_surface(const InputFile   &input,
               const std::string &path,
               const std::string &file)
  {
    input.require(!file.empty(), path, "the name of a file is needed.");
    const std::string filename =
      readable_file(input, path, file, largest_surface);
    input.require(is_known(filename),
                  path,
                  filename + ": the name of a surface ends in .stl, .obj, .ply "
                             "or .off.");
    Assimp::Importer importer;
    const aiScene   *scene =
      importer.ReadFile(filename,
                        aiProcess_Triangulate | aiProcess_PreTransformVertices);
    input.require(scene != nullptr && scene->mNumMeshes > 0,
                  path,
                  filename + ": " +
                    (scene != nullptr ? "there are no triangles." :
                                        importer.GetErrorString()));
    SurfaceBuilder builder;
    for (unsigned int m = 0; m < scene->mNumMeshes; ++m)
      builder.add(*scene->mMeshes[m]);
    input.require(builder.is_finite,
                  path,
                  filename + ": a coordinate is not finite.");
    require_digits(input, path, filename, builder.surface);
    const std::string problem = problem_of_surface(builder.surface);
    input.require(problem.empty(), path, filename + ": " + problem);
    return std::move(builder.surface);
  }
} // namespace seiche
