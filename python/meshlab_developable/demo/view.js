// SPDX-License-Identifier: GPL-3.0-or-later
// view.js: shapes that turn in the page: drag or arrow keys turn them, the wheel and + and - bring them nearer.
"use strict";

const vertexShader = `#version 300 es
in vec3 position, normal, colour;
uniform mat3 turn;
uniform vec3 centre;
uniform vec2 scale;
uniform float depth;
out vec3 shaded, facing;
void main() {
	vec3 seen = turn * (position - centre);
	gl_Position = vec4(seen.xy * scale, -seen.z * depth, 1.0);
	facing = turn * normal;
	shaded = colour;
}`;

const fragmentShader = `#version 300 es
precision mediump float;
in vec3 shaded, facing;
out vec4 result;
void main() {
	vec3 n = normalize(facing);
	float light = abs(dot(n, normalize(vec3(0.3, 0.4, 1.0))));
	result = vec4(shaded * (0.35 + 0.65 * light), 1.0);
}`;

const decoded = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;

/** Normals of vertices, each triangle weighted by its area. */
function vertexNormals(positions, corners) {
	const normals = new Float32Array(positions.length);
	for (let i = 0; i < corners.length; i += 3) {
		const [a, b, c] = [3 * corners[i], 3 * corners[i + 1], 3 * corners[i + 2]];
		const u = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
		const v = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
		for (let k = 0; k < 3; ++k) {
			const [p, q] = [(k + 1) % 3, (k + 2) % 3];
			const value = u[p] * v[q] - u[q] * v[p];
			for (const vertex of [a, b, c]) normals[vertex + k] += value;
		}
	}
	return normals;
}

/** Middle and half diagonal of the box. */
function frame(positions) {
	const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
	positions.forEach((value, i) => {
		low[i % 3] = Math.min(low[i % 3], value);
		high[i % 3] = Math.max(high[i % 3], value);
	});
	return { centre: low.map((value, k) => (value + high[k]) / 2), radius: Math.hypot(...low.map((v, k) => high[k] - v)) / 2 };
}

const product = (a, b) => a.map((_, i) => {
	const row = Math.floor(i / 3), column = i % 3;
	return [0, 1, 2].reduce((sum, k) => sum + a[3 * row + k] * b[3 * k + column], 0);
});

/** Rotation about the screen's own axes, by rows. */
function rotation(across, up) {
	const [c, s, d, t] = [Math.cos(across), Math.sin(across), Math.cos(up), Math.sin(up)];
	return product([1, 0, 0, 0, d, -t, 0, t, d], [c, 0, s, 0, 1, 0, -s, 0, c]);
}

function compile(gl) {
	const program = gl.createProgram();
	for (const [kind, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
		const shader = gl.createShader(kind);
		gl.shaderSource(shader, source);
		gl.compileShader(shader);
		if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
		gl.attachShader(program, shader);
	}
	gl.linkProgram(program);
	gl.useProgram(program);
	return program;
}

function show(element) {
	const data = JSON.parse(element.querySelector("script").textContent);
	const canvas = element.querySelector("canvas");
	const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
	if (!gl) {
		element.querySelector(".hint").textContent = "This browser has no WebGL: there is no view to turn.";
		return;
	}
	const program = compile(gl);
	const corners = new Uint32Array(decoded(data.faces));
	const shapes = data.shapes.map((shape) => {
		const positions = new Float32Array(decoded(shape.positions));
		return { positions, normals: vertexNormals(positions, corners), colours: new Uint8Array(decoded(shape.colours)) };
	});
	const { centre, radius } = frame(shapes[0].positions);
	let turn = data.turn, zoom = 1;

	function load(name, values, type) {
		const place = gl.getAttribLocation(program, name);
		gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
		gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
		gl.enableVertexAttribArray(place);
		gl.vertexAttribPointer(place, 3, type, type === gl.UNSIGNED_BYTE, 0, 0);
	}

	function draw() {
		const uniform = (name) => gl.getUniformLocation(program, name);
		const wide = canvas.width / canvas.height, scale = zoom / radius;
		gl.viewport(0, 0, canvas.width, canvas.height);
		gl.clearColor(1, 1, 1, 1);
		gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
		gl.enable(gl.DEPTH_TEST);
		gl.uniformMatrix3fv(uniform("turn"), true, turn);
		gl.uniform3fv(uniform("centre"), centre);
		gl.uniform2f(uniform("scale"), scale / Math.max(wide, 1), scale * Math.min(wide, 1));
		gl.uniform1f(uniform("depth"), 0.5 / radius);
		gl.drawElements(gl.TRIANGLES, corners.length, gl.UNSIGNED_INT, 0);
	}

	function choose(index) {
		const shape = shapes[index];
		load("position", shape.positions, gl.FLOAT);
		load("normal", shape.normals, gl.FLOAT);
		load("colour", shape.colours, gl.UNSIGNED_BYTE);
		draw();
	}

	function move(across, up) {
		turn = product(rotation(across, up), turn);
		draw();
	}

	function approach(factor) {
		zoom = Math.min(20, Math.max(0.2, zoom * factor));
		draw();
	}

	gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
	gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, corners, gl.STATIC_DRAW);
	element.querySelectorAll("input").forEach((button, index) => button.addEventListener("change", () => choose(index)));
	canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
	canvas.addEventListener("pointermove", (event) => {
		if (event.buttons) move(event.movementX / 120, event.movementY / 120);
	});
	canvas.addEventListener("wheel", (event) => {
		event.preventDefault();
		approach(Math.exp(-event.deltaY / 600));
	}, { passive: false });
	const keys = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
	canvas.addEventListener("keydown", (event) => {
		if (keys[event.key]) move(...keys[event.key]);
		else if (event.key === "+" || event.key === "-") approach(event.key === "+" ? 1.1 : 1 / 1.1);
		else return;
		event.preventDefault();
	});
	choose(0);
}

document.querySelectorAll(".view").forEach(show);
