// Delaunator, which rests on robust-predicates, in a process of its own like every peer.
// It reads and writes as peer_run.hpp says; faces at infinity are not its own.
// The first argument is the folder of the module.
import { readFileSync, writeSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
import { join } from 'node:path';

const require = createRequire(join(process.argv[2], 'package.json'));
const { default: Delaunator } = await import(pathToFileURL(require.resolve('delaunator')));

const bytes = readFileSync(0);
const sites = new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const coordinates = new Float64Array((sites.length / 3) * 2);
for (let i = 0; i < sites.length / 3; ++i) coordinates.set([sites[3 * i], sites[3 * i + 1]], 2 * i);
const peak = () => 1024 * Number(/VmHWM:\s+(\d+)/.exec(readFileSync('/proc/self/status', 'utf8'))[1]);
const before = peak();
const start = process.hrtime.bigint();
const { triangles } = new Delaunator(coordinates);
const seconds = Number(process.hrtime.bigint() - start) / 1e9;

const write = (view) => {
  const data = Buffer.from(view.buffer, view.byteOffset, view.byteLength);
  for (let done = 0; done < data.length; ) done += writeSync(1, data, done);
};
write(new Float64Array([seconds, peak() - before, triangles.length / 3]));
write(new Int32Array(triangles));
write(new Float64Array([0]));
