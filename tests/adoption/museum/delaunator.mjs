// Triangulations by delaunator: delaunator.mjs FOLDER SITES 2 prints a face a line.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
import { join } from 'node:path';

const [folder, path] = process.argv.slice(2);
const require = createRequire(join(folder, 'package.json'));
const { default: Delaunator } = await import(pathToFileURL(require.resolve('delaunator')));
const numbers = readFileSync(path, 'utf8').trim().split(/\s+/).map(Number);
const { triangles } = new Delaunator(Float64Array.from(numbers));
for (let k = 0; k < triangles.length; k += 3)
  console.log(triangles[k], triangles[k + 1], triangles[k + 2]);
