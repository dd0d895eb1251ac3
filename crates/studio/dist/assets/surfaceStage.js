import{D as e,O as t,S as n,_ as r,a as i,c as a,d as o,f as s,h as c,i as l,j as u,l as d,n as f,o as p,r as m,t as h,v as g,w as _,x as v,y}from"./software.js";import{i as b,r as x}from"./index.js";var S=`
attribute vec3 moved;
uniform float factor;
`,C=`${S}
attribute float value;
varying float shown;
varying vec3 eye;

void main() {
  vec4 place = modelViewMatrix * vec4(position + factor * moved, 1.0);
  shown = value;
  eye = place.xyz;
  gl_Position = projectionMatrix * place;
}`,w=`
uniform vec3 bands[${b.length}];
uniform vec3 above;
varying float shown;
varying vec3 eye;

void main() {
  vec3 away = normalize(cross(dFdx(eye), dFdy(eye)));
  float light = 0.66 + 0.34 * max(0.0, dot(away, normalize(vec3(-0.3, 0.45, 0.85))));
  vec3 colour = shown > 1.0 ? above : bands[int(clamp(floor(shown * ${b.length}.0), 0.0, ${b.length-1}.0))];
  gl_FragColor = vec4(colour * light, 1.0);
}`,T=`${S}
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position + factor * moved, 1.0);
}`,E=`
uniform vec3 ink;

void main() {
  gl_FragColor = vec4(ink, 0.55);
}`,D=class{faces=new t({uniforms:{factor:{value:0},bands:{value:b.map(e=>new o(e))},above:{value:new o(x)}},vertexShader:C,fragmentShader:w,side:2,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:2});edges=new t({uniforms:{factor:{value:0},ink:{value:new o(`#05070a`)}},vertexShader:T,fragmentShader:E,transparent:!0});ghost=new g({transparent:!0,opacity:.5});set factor(e){for(let{uniforms:t}of[this.faces,this.edges])t.factor&&(t.factor.value=e)}set ink(e){this.ghost.color.set(e)}free(){for(let e of[this.faces,this.edges,this.ghost])e.dispose()}},O=Math.cos(32*Math.PI/180);function k({nodes:e,triangles:t}){let n=j(e,t),r=e.length/3,i=new Map,a=[];for(let e=0;e<t.length/3;e++)for(let o=0;o<3;o++){let s=t[3*e+o],c=t[3*e+(o+1)%3],l=Math.min(s,c)*r+Math.max(s,c),u=i.get(l);u===void 0?i.set(l,e):A(n,e,u)<O&&a.push(s,c)}return new Uint32Array(a)}function A(e,t,n){let r=0;for(let i=0;i<3;i++)r+=e[3*t+i]*e[3*n+i];return r}function j(e,t){let n=new Float32Array(t.length),r=(t,n)=>e[3*t+n];for(let e=0;e<t.length;e+=3){let[i,a,o]=[0,1,2].map(n=>t[e+n]),[s,c]=[a,o].map(e=>[0,1,2].map(t=>r(e,t)-r(i,t))),l=[s[1]*c[2]-s[2]*c[1],s[2]*c[0]-s[0]*c[2],s[0]*c[1]-s[1]*c[0]],u=Math.hypot(...l)||1;l.forEach((t,r)=>n[e+r]=t/u)}return n}s.enabled=!1;var M=class{onframe=()=>{};#e;#t=new e;#n=new r;#r=new _(22,1,.01,100);#i;#a=new D;#o=h();#s;#c=new d;#l=new d;#u=new a(new Float32Array,1);#d=new a(new Float32Array,3);#f=0;#p=0;#m=[1,1];#h;constructor(e){this.#e=new p({canvas:e,antialias:!this.#o,powerPreference:`high-performance`}),this.#e.outputColorSpace=v,this.#e.setPixelRatio(this.#o?1:Math.min(devicePixelRatio,2)),this.#t.add(this.#n),this.#r.up.set(1,0,0),this.#i=new i(this.#r,e),this.#i.enableDamping=!1,this.#i.zoomToCursor=!0,this.#i.addEventListener(`change`,()=>this.#g()),this.#i.addEventListener(`start`,()=>this.#h=void 0)}#g(){this.#p===0&&(this.#p=requestAnimationFrame(()=>{this.#p=0,this.#e.render(this.#t,this.#r),this.onframe()}))}resize(e,t){e<1||t<1||(this.#m=[e,t],this.#r.aspect=e/t,this.#r.updateProjectionMatrix(),this.#e.setSize(e,t,!1),this.#h&&this.look(this.#h),this.#g())}theme(e,t){this.#t.background=new o(e),this.#a.ink=t,this.#g()}show(e,t){let r=this.#s===void 0;this.#s=e,this.#_(),this.#n.scale.y=t?-1:1;let i=e.nodes.length/3,o=new a(e.nodes,3);this.#u=new a(new Float32Array(i),1).setUsage(c),this.#d=new a(new Float32Array(3*i),3).setUsage(c),this.#c=new d,this.#l=new d;for(let e of[this.#c,this.#l])e.setAttribute(`position`,o),e.setAttribute(`moved`,this.#d);this.#c.setAttribute(`value`,this.#u),this.#c.setIndex(new a(e.triangles,1)),this.#l.setIndex(new a(k(e),1));let s=[new n(this.#c,this.#a.faces),new y(this.#l,this.#a.edges),new y(this.#l,this.#a.ghost)];for(let e of s)e.frustumCulled=!1;this.#n.add(...s),this.#n.updateMatrixWorld(!0),r&&this.look(`iso`),this.#g()}#_(){this.#n.clear(),this.#c.dispose(),this.#l.dispose()}paint(e,t){e.length===this.#u.count&&(this.#u.copyArray(e).needsUpdate=!0,this.#d.copyArray(t).needsUpdate=!0,this.#g())}magnify(e){this.#f=e,this.#a.factor=e,this.#g()}ghost(e){this.#a.ghost.visible=e,this.#g()}place(e){if(!this.#s||e>=this.#u.count)return null;let{x:t,y:n}=this.#v(e).project(this.#r);return{x:(1+t)/2*this.#m[0],y:(1-n)/2*this.#m[1]}}#v(e){let t=new u().fromArray(this.#s?.nodes??[],3*e);return t.addScaledVector(new u().fromBufferAttribute(this.#d,e),this.#f),t.applyMatrix4(this.#n.matrixWorld)}look(e){if(!this.#s)return;this.#h=e;let t=new u(...m(e)),n=this.#s.nodes.slice();if(this.#n.scale.y<0)for(let e=1;e<n.length;e+=3)n[e]=-n[e];let{target:r,far:i}=f(n,t,this.#r);i>0&&this.#y(r,t,1.06*i)}#y(e,t,n){this.#i.target.copy(e),this.#r.position.copy(e).addScaledVector(t,n),this.#r.near=n/60,this.#r.far=n*8,this.#r.updateProjectionMatrix(),this.#i.update(),this.#g()}face(e){if(!this.#s)return;this.#h=void 0;let t=N(this.#s,e);t.z*=.2,t.y*=this.#n.scale.y,Math.hypot(t.y,t.z)<.2*t.length()&&(t.y+=.25*t.length());let n=this.#r.position.distanceTo(this.#i.target);this.#y(this.#v(e),t.normalize(),n)}orbit(e,t){this.#h=void 0,l(this.#r,this.#i.target,e,t),this.#i.update(),this.#g()}zoom(e){this.#h=void 0,this.#r.position.lerp(this.#i.target,1-1/e),this.#i.update(),this.#g()}dispose(){cancelAnimationFrame(this.#p),this.#_(),this.#a.free(),this.#i.dispose(),this.#e.dispose()}};function N({nodes:e,triangles:t},n){let r=new u,[i,a,o]=[new u,new u,new u];for(let s=0;s<t.length;s+=3)(t[s]===n||t[s+1]===n||t[s+2]===n)&&([i,a,o].forEach((n,r)=>n.fromArray(e,3*t[s+r])),r.add(a.sub(i).cross(o.sub(i))));return r.lengthSq()>0?r.normalize():r.set(0,1,0)}export{M as SurfaceStage};