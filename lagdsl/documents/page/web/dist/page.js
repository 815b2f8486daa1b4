"use strict";(()=>{var l_="uplot",c_="u-hz",h_="u-vt",u_="u-title",d_="u-wrap",f_="u-under",p_="u-over",m_="u-axis",Ks="u-off",g_="u-select",__="u-cursor-x",x_="u-cursor-y",y_="u-cursor-pt",v_="u-legend",b_="u-live",M_="u-inline",S_="u-series",w_="u-marker",Cf="u-label",T_="u-value",Oo="width",Fo="height";var Rf="bottom",Er="left",Yh="right",cu="#000",Pf=cu+"0",qh="mousemove",If="mousedown",$h="mouseup",Lf="mouseenter",Df="mouseleave",Nf="dblclick",A_="resize",E_="scroll",Uf="change",Za="dppxchange",hu="--",Nr=typeof window<"u",Qh=Nr?document:null,Rr=Nr?window:null,C_=Nr?navigator:null,Pt,Xa;function eu(){let i=devicePixelRatio;Pt!=i&&(Pt=i,Xa&&nu(Uf,Xa,eu),Xa=matchMedia(`(min-resolution: ${Pt-.001}dppx) and (max-resolution: ${Pt+.001}dppx)`),js(Uf,Xa,eu),Rr.dispatchEvent(new CustomEvent(Za)))}function ii(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function tu(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function $t(i,e,t){i.style[e]=t+"px"}function bi(i,e,t,n){let s=Qh.createElement(i);return e!=null&&ii(s,e),t?.insertBefore(s,n),s}function fi(i,e){return bi("div",i,e)}var Of=new WeakMap;function Gi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Of.get(i);r!=o&&(i.style.transform=r,Of.set(i,r),e<0||t<0||e>n||t>s?ii(i,Ks):tu(i,Ks))}var Ff=new WeakMap;function Bf(i,e,t){let n=e+t,s=Ff.get(i);n!=s&&(Ff.set(i,n),i.style.background=e,i.style.borderColor=t)}var zf=new WeakMap;function kf(i,e,t,n){let s=e+""+t,r=zf.get(i);s!=r&&(zf.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var uu={passive:!0},R_={...uu,capture:!0};function js(i,e,t,n){e.addEventListener(i,t,n?R_:uu)}function nu(i,e,t,n){e.removeEventListener(i,t,uu)}Nr&&eu();function Mi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:si((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function pp(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var mp=i=>i!=null,gp=i=>i!=null&&i>0,ja=pp(mp),P_=pp(gp);function I_(i,e,t,n=0,s=!1){let r=s?P_:ja,o=s?gp:mp;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Gt,l??-Gt]}function Qa(i,e,t,n){let s=Vf(i),r=Vf(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?is:_p,a=s==1?si:pi,l=r==1?pi:si,c=a(o(gn(i))),h=l(o(gn(e))),u=Pr(t,c),d=Pr(t,h);return t==10&&(c<0&&(u=Ht(u,-c)),h<0&&(d=Ht(d,-h))),n||t==2?(i=u*s,e=d*r):(i=bp(i,u),e=el(e,d)),[i,e]}function du(i,e,t,n){let s=Qa(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var fu=.1,Gf={mode:3,pad:fu},zo={pad:0,soft:null,mode:0},L_={min:zo,max:zo};function Ja(i,e,t,n){return tl(t)?Hf(i,e,t):(zo.pad=t,zo.soft=n?0:null,zo.mode=n?3:0,Hf(i,e,L_))}function Et(i,e){return i??e}function D_(i,e,t){for(e=Et(e,0),t=Et(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Hf(i,e,t){let n=t.min,s=t.max,r=Et(n.pad,0),o=Et(s.pad,0),a=Et(n.hard,-Gt),l=Et(s.hard,Gt),c=Et(n.soft,Gt),h=Et(s.soft,-Gt),u=Et(n.mode,0),d=Et(s.mode,0),f=e-i,g=is(f),b=Gn(gn(i),gn(e)),p=is(b),m=gn(p-g);(f<1e-24||m>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Gt&&(r=0),d==2&&h!=-Gt&&(o=0)));let v=f||b||1e3,C=is(v),M=Pr(10,si(C)),R=v*(f==0?i==0?.1:1:r),E=Ht(bp(i-R,M/10),24),y=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:Gt,A=Gn(a,E<y&&i>=y?y:Si(y,E)),k=v*(f==0?e==0?.1:1:o),U=Ht(el(e+k,M/10),24),L=e<=h&&(d==1||d==3&&U>=h||d==2&&U<=h)?h:-Gt,G=Si(l,U>L&&e<=L?L:Gn(L,U));return A==G&&A==0&&(G=100),[A,G]}var N_=new Intl.NumberFormat(Nr?C_.language:"en-US"),pu=i=>N_.format(i),ri=Math,$a=ri.PI,gn=ri.abs,si=ri.floor,mn=ri.round,pi=ri.ceil,Si=ri.min,Gn=ri.max,Pr=ri.pow,Vf=ri.sign,is=ri.log10,_p=ri.log2,U_=(i,e=1)=>ri.sinh(i)*e,Zh=(i,e=1)=>ri.asinh(i/e),Gt=1/0;function Wf(i){return(is((i^i>>31)-(i>>31))|0)+1}function iu(i,e,t){return Si(Gn(i,e),t)}function xp(i){return typeof i=="function"}function wt(i){return xp(i)?i:()=>i}var O_=()=>{},yp=i=>i,vp=(i,e)=>e,F_=i=>null,Xf=i=>!0,Yf=(i,e)=>i==e,B_=/\.\d*?(?=9{6,}|0{6,})/gm,Qs=i=>{if(Sp(i)||Ps.has(i))return i;let e=`${i}`,t=e.match(B_);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Qs(s)}e${r}`}return Ht(i,n)};function Zs(i,e){return Qs(Ht(Qs(i/e))*e)}function el(i,e){return Qs(pi(Qs(i/e))*e)}function bp(i,e){return Qs(si(Qs(i/e))*e)}function Ht(i,e=0){if(Sp(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return mn(n)/t}var Ps=new Map;function Mp(i){return((""+i).split(".")[1]||"").length}function Go(i,e,t,n){let s=[],r=n.map(Mp);for(let o=e;o<t;o++){let a=gn(o),l=Ht(Pr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Ht(h,u);s.push(d),Ps.set(d,u)}}return s}var ko={},mu=[],Ir=[null,null],Rs=Array.isArray,Sp=Number.isInteger,z_=i=>i===void 0;function qf(i){return typeof i=="string"}function tl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function k_(i){return i!=null&&typeof i=="object"}var G_=Object.getPrototypeOf(Uint8Array),wp="__proto__";function Lr(i,e=tl){let t;if(Rs(i)){let n=i.find(s=>s!=null);if(Rs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Lr(i[s],e)}else t=i.slice()}else if(i instanceof G_)t=i.slice();else if(e(i)){t={};for(let n in i)n!=wp&&(t[n]=Lr(i[n],e))}else t=i;return t}function dn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=wp&&(tl(i[s])?dn(i[s],Lr(n[s])):i[s]=Lr(n[s]))}return i}var H_=0,V_=1,W_=2;function X_(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Y_(i,e){if(Z_(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return J_(o[0])||(o=$_(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:V_,f=[];for(let g=0;g<h.length;g++){let b=h[g],p=r.get(l[g]);b===null?d!=H_&&(u[p]=b,d==W_&&f.push(p)):u[p]=b}X_(u,f,s),n.push(u)}}return n}var q_=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function $_(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function Z_(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function J_(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Gn(1,si((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Tp=["January","February","March","April","May","June","July","August","September","October","November","December"],Ap=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Ep(i){return i.slice(0,3)}var K_=Ap.map(Ep),j_=Tp.map(Ep),Q_={MMMM:Tp,MMM:j_,WWWW:Ap,WWW:K_};function Uo(i){return(i<10?"0":"")+i}function ex(i){return(i<10?"00":i<100?"0":"")+i}var tx={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Uo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Uo(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Uo(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Uo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Uo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>ex(i.getMilliseconds())};function gu(i,e){e=e||Q_;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?tx[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var nx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function ix(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==nx?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Cp=i=>i%1==0,Ka=[1,2,2.5,5],sx=Go(10,-32,0,Ka),Rp=Go(10,0,32,Ka),rx=Rp.filter(Cp),Js=sx.concat(Rp),_u=`
`,Pp="{YYYY}",$f=_u+Pp,Ip="{M}/{D}",Bo=_u+Ip,Ya=Bo+"/{YY}",Lp="{aa}",ox="{h}:{mm}",Cr=ox+Lp,Zf=_u+Cr,Jf=":{ss}",Dt=null;function Dp(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Go(10,0,3,Ka).filter(Cp):Go(10,-3,0,Ka)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Pp,Dt,Dt,Dt,Dt,Dt,Dt,1],[s*28,"{MMM}",$f,Dt,Dt,Dt,Dt,Dt,1],[s,Ip,$f,Dt,Dt,Dt,Dt,Dt,1],[n,"{h}"+Lp,Ya,Dt,Bo,Dt,Dt,Dt,1],[t,Cr,Ya,Dt,Bo,Dt,Dt,Dt,1],[e,Jf,Ya+" "+Cr,Dt,Bo+" "+Cr,Dt,Zf,Dt,1],[i,Jf+".{fff}",Ya+" "+Cr,Dt,Bo+" "+Cr,Dt,Zf,Dt,1]];function h(u){return(d,f,g,b,p,m)=>{let v=[],C=p>=o,M=p>=r&&p<o,R=u(g),E=Ht(R*i,3),y=Jh(R.getFullYear(),C?0:R.getMonth(),M||C?1:R.getDate()),A=Ht(y*i,3);if(M||C){let k=M?p/r:0,U=C?p/o:0,L=E==A?E:Ht(Jh(y.getFullYear()+U,y.getMonth()+k,1)*i,3),G=new Date(mn(L/i)),X=G.getFullYear(),D=G.getMonth();for(let V=0;L<=b;V++){let Y=Jh(X+U*V,D+k*V,1),H=Y-u(Ht(Y*i,3));L=Ht((+Y+H)*i,3),L<=b&&v.push(L)}}else{let k=p>=s?s:p,U=si(g)-si(E),L=A+U+el(E-A,k);v.push(L);let G=u(L),X=G.getHours()+G.getMinutes()/t+G.getSeconds()/n,D=p/n,V=d.axes[f]._space,Y=m/V;for(;L=Ht(L+p,i==1?0:3),!(L>b);)if(D>1){let H=si(Ht(X+D,6))%24,j=u(L).getHours()-H;j>1&&(j=-1),L-=j*n,X=(X+D)%24;let ie=v[v.length-1];Ht((L-ie)/p,3)*Y>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,h]}var[ax,lx,cx]=Dp(1),[hx,ux,dx]=Dp(.001);Go(2,-53,53,[1]);function Kf(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function jf(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,f;return n.map(g=>{let b=i(g),p=b.getFullYear(),m=b.getMonth(),v=b.getDate(),C=b.getHours(),M=b.getMinutes(),R=b.getSeconds(),E=p!=l&&a[2]||m!=c&&a[3]||v!=h&&a[4]||C!=u&&a[5]||M!=d&&a[6]||R!=f&&a[7]||a[1];return l=p,c=m,h=v,u=C,d=M,f=R,E(b)})}}function fx(i,e){let t=gu(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Jh(i,e,t){return new Date(i,e,t)}function Qf(i,e){return e(i)}var px="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function ep(i,e){return(t,n,s,r)=>r==null?hu:e(i(n))}function mx(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function gx(i,e){return i.series[e].fill(i,e)}var _x={show:!0,live:!0,isolate:!1,mount:O_,markers:{show:!0,width:2,stroke:mx,fill:gx,dash:"solid"},idx:null,idxs:null,values:[]};function xx(i,e){let t=i.cursor.points,n=fi(),s=t.size(i,e);$t(n,Oo,s),$t(n,Fo,s);let r=s/-2;$t(n,"marginLeft",r),$t(n,"marginTop",r);let o=t.width(i,e,s);return o&&$t(n,"borderWidth",o),n}function yx(i,e){let t=i.series[e].points;return t._fill||t._stroke}function vx(i,e){let t=i.series[e].points;return t._stroke||t._fill}function bx(i,e){return i.series[e].points.size}var Kh=[0,0];function Mx(i,e,t){return Kh[0]=e,Kh[1]=t,Kh}function qa(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function jh(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var Sx={show:!0,x:!0,y:!0,lock:!1,move:Mx,points:{one:!1,show:xx,size:bx,width:0,stroke:vx,fill:yx},bind:{mousedown:qa,mouseup:qa,click:qa,dblclick:qa,mousemove:jh,mouseleave:jh,mouseenter:jh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Np={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},xu=dn({},Np,{filter:vp}),Up=dn({},xu,{size:10}),Op=dn({},Np,{show:!1}),yu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Fp="bold "+yu,Bp=1.5,tp={show:!0,scale:"x",stroke:cu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Fp,side:2,grid:xu,ticks:Up,border:Op,font:yu,lineGap:Bp,rotate:0},wx="Value",Tx="Time",np={show:!0,scale:"x",auto:!1,sorted:1,min:Gt,max:-Gt,idxs:[]};function Ax(i,e,t,n,s){return e.map(r=>r==null?"":pu(r))}function Ex(i,e,t,n,s,r,o){let a=[],l=Ps.get(s)||0;t=o?t:Ht(el(t,s),l);for(let c=t;c<=n;c=Ht(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function su(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?is:_p,h=si(c(t));s=Pr(l,h),l==10&&(s=Js[Mi(s,Js)]);let u=t,d=s*l;l==10&&(d=Js[Mi(d,Js)]);do a.push(u),u=u+s,l==10&&!Ps.has(u)&&(u=Ht(u,Ps.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Js[Mi(d,Js)]));while(u<=n);return a}function Cx(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?su(i,e,Gn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?su(i,e,Gn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var zp=/./,Rx=/[12357]/,Px=/[125]/,ip=/1/,ru=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Ix(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?zp:l(7,o)-h>=c?Rx:l(5,o)-h>=c?Px:ip;if(u==ip){let d=gn(l(1,o)-h);if(d<c)return ru(e.slice().reverse(),a.distr,u,pi(c/d)).reverse()}return ru(e,a.distr,u,1)}function Lx(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=gn(l(1,o)-l(2,o));return c<a?ru(e.slice().reverse(),3,zp,pi(a/c)).reverse():e}function Dx(i,e,t,n){return n==null?hu:e==null?"":pu(e)}var sp={show:!0,scale:"y",stroke:cu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Fp,side:3,grid:xu,ticks:Up,border:Op,font:yu,lineGap:Bp,rotate:0};function Nx(i,e){let t=3+(i||1)*2;return Ht(t*e,3)}function Ux(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=gn(o-r),l=i.series[e],c=a/(l.points.space*Pt);return n[1]-n[0]<=c}var rp={scale:null,auto:!0,sorted:0,min:Gt,max:-Gt},kp=(i,e,t,n,s)=>s,op={show:!0,auto:!0,sorted:0,gaps:kp,alpha:1,facets:[dn({},rp,{scale:"x"}),dn({},rp,{scale:"y"})]},ap={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:kp,alpha:1,points:{show:Ux,filter:null},values:null,min:Gt,max:-Gt,idxs:[],path:null,clip:null};function Ox(i,e,t,n,s){return t/10}var Gp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Fx=dn({},Gp,{time:!1,ori:1}),lp={};function Hp(i,e){let t=lp[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(lp[i]=t)),t}var Dr=1,ou=2;function er(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,b=a.height,p=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,l,c,h,u,p,m,d,f,g,b,il,Ur,rl,Wp,Yp):t(s,l,c,h,u,m,p,f,d,b,g,sl,Or,Mu,Xp,qp)}function vu(i,e){let t=0,n=0,s=Et(i.bands,mu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Bx(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ss(i,e,t,n,s,r){return er(i,e,(o,a,l,c,h,u,d,f,g,b,p)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),C=c.ori==0?Ur:Or,M,R;v==1?(M=t,R=n):(M=n,R=t);let E=m(u(a[M],c,b,f)),y=m(d(l[M],h,p,g)),A=m(u(a[R],c,b,f)),k=m(d(r==1?h.max:h.min,h,p,g)),U=new Path2D(s);return C(U,A,k),C(U,E,k),C(U,E,y),U})}function nl(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?rl:Mu,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function zx(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function bu(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),g=d==u?f:r(i[d]),b=u-s;f=o<=0&&b>=0&&b<l?r(i[b]):f;let m=d+s;g=o>=0&&m>=0&&m<l?r(i[m]):g,g>=f&&a.push([f,g])}return a}function cp(i){return i==0?yp:i==1?mn:e=>Zs(e,i)}function Vp(i){let e=i==0?il:sl,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Si(c,a/2,l/2),h=Si(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var il=(i,e,t)=>{i.moveTo(e,t)},sl=(i,e,t)=>{i.moveTo(t,e)},Ur=(i,e,t)=>{i.lineTo(e,t)},Or=(i,e,t)=>{i.lineTo(t,e)},rl=Vp(0),Mu=Vp(1),Wp=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Xp=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Yp=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},qp=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function $p(i){return(e,t,n,s,r)=>er(e,t,(o,a,l,c,h,u,d,f,g,b,p)=>{let{pxRound:m,points:v}=o,C,M;c.ori==0?(C=il,M=Wp):(C=sl,M=Xp);let R=Ht(v.width*Pt,3),E=(v.size-v.width)/2*Pt,y=Ht(E*2,3),A=new Path2D,k=new Path2D,{left:U,top:L,width:G,height:X}=e.bbox;rl(k,U-y,L-y,G+y*2,X+y*2);let D=V=>{if(l[V]!=null){let Y=m(u(a[V],c,b,f)),H=m(d(l[V],h,p,g));C(A,Y+E,H),M(A,Y,H,E,0,$a*2)}};if(r)r.forEach(D);else for(let V=n;V<=s;V++)D(V);return{stroke:R>0?A:null,fill:A,clip:k,flags:Dr|ou}})}function Zp(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var kx=Zp(Ur),Gx=Zp(Or);function Jp(i){let e=Et(i?.alignGaps,0);return(t,n,s,r)=>er(t,n,(o,a,l,c,h,u,d,f,g,b,p)=>{[s,r]=ja(l,s,r);let m=o.pxRound,v=X=>m(u(X,c,b,f)),C=X=>m(d(X,h,p,g)),M,R;c.ori==0?(M=Ur,R=kx):(M=Or,R=Gx);let E=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Dr},A=y.stroke,k=!1;if(r-s>=b*4){let X=he=>t.posToVal(he,c.key,!0),D=null,V=null,Y,H,ce,q=v(a[E==1?s:r]),j=v(a[s]),ie=v(a[r]),pe=X(E==1?j+1:ie-1);for(let he=E==1?s:r;he>=s&&he<=r;he+=E){let ee=a[he],Me=(E==1?ee<pe:ee>pe)?q:v(ee),Le=l[he];Me==q?Le!=null?(H=Le,D==null?(M(A,Me,C(H)),Y=D=V=H):H<D?D=H:H>V&&(V=H)):Le===null&&(k=!0):(D!=null&&R(A,q,C(D),C(V),C(Y),C(H)),Le!=null?(H=Le,M(A,Me,C(H)),D=V=Y=H):(D=V=null,Le===null&&(k=!0)),q=Me,pe=X(q+E))}D!=null&&D!=V&&ce!=q&&R(A,q,C(D),C(V),C(Y),C(H))}else for(let X=E==1?s:r;X>=s&&X<=r;X+=E){let D=l[X];D===null?k=!0:D!=null&&M(A,v(a[X]),C(D))}let[L,G]=vu(t,n);if(o.fill!=null||L!=0){let X=y.fill=new Path2D(A),D=o.fillTo(t,n,o.min,o.max,L),V=C(D),Y=v(a[s]),H=v(a[r]);E==-1&&([H,Y]=[Y,H]),M(X,H,V),M(X,Y,V)}if(!o.spanGaps){let X=[];k&&X.push(...bu(a,l,s,r,E,v,e)),y.gaps=X=o.gaps(t,n,s,r,X),y.clip=nl(X,c.ori,f,g,b,p)}return G!=0&&(y.band=G==2?[ss(t,n,s,r,A,-1),ss(t,n,s,r,A,1)]:ss(t,n,s,r,A,G)),y})}function Hx(i){let e=Et(i.align,1),t=Et(i.ascDesc,!1),n=Et(i.alignGaps,0),s=Et(i.extend,!1);return(r,o,a,l)=>er(r,o,(c,h,u,d,f,g,b,p,m,v,C)=>{[a,l]=ja(u,a,l);let M=c.pxRound,{left:R,width:E}=r.bbox,y=j=>M(g(j,d,v,p)),A=j=>M(b(j,f,C,m)),k=d.ori==0?Ur:Or,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Dr},L=U.stroke,G=d.dir*(d.ori==0?1:-1),X=A(u[G==1?a:l]),D=y(h[G==1?a:l]),V=D,Y=D;s&&e==-1&&(Y=R,k(L,Y,X)),k(L,D,X);for(let j=G==1?a:l;j>=a&&j<=l;j+=G){let ie=u[j];if(ie==null)continue;let pe=y(h[j]),he=A(ie);e==1?k(L,pe,X):k(L,V,he),k(L,pe,he),X=he,V=pe}let H=V;s&&e==1&&(H=R+E,k(L,H,X));let[ce,q]=vu(r,o);if(c.fill!=null||ce!=0){let j=U.fill=new Path2D(L),ie=c.fillTo(r,o,c.min,c.max,ce),pe=A(ie);k(j,H,pe),k(j,Y,pe)}if(!c.spanGaps){let j=[];j.push(...bu(h,u,a,l,G,y,n));let ie=c.width*Pt/2,pe=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;j.forEach(ee=>{ee[0]+=pe,ee[1]+=he}),U.gaps=j=c.gaps(r,o,a,l,j),U.clip=nl(j,d.ori,p,m,v,C)}return q!=0&&(U.band=q==2?[ss(r,o,a,l,L,-1),ss(r,o,a,l,L,1)]:ss(r,o,a,l,L,q)),U})}function hp(i,e,t,n,s,r,o=Gt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=gn(i[l]-i[a]);h<c&&(c=h,o=gn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function Vx(i){i=i||ko;let e=Et(i.size,[.6,Gt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=wt(s),o=1-e[0],a=Et(e[1],Gt),l=Et(e[2],1),c=Et(i.disp,ko),h=Et(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,g,b,p)=>er(f,g,(m,v,C,M,R,E,y,A,k,U,L)=>{let G=m.pxRound,X=t,D=n*Pt,V=a*Pt,Y=l*Pt,H,ce;M.ori==0?[H,ce]=r(f,g):[ce,H]=r(f,g);let q=M.dir*(M.ori==0?1:-1),j=M.ori==0?rl:Mu,ie=M.ori==0?h:(ue,ke,Ue,ye,Xe,Te,Ge)=>{h(ue,ke,Ue,Xe,ye,Ge,Te)},pe=Et(f.bands,mu).find(ue=>ue.series[0]==g),he=pe!=null?pe.dir:0,ee=m.fillTo(f,g,m.min,m.max,he),ge=G(y(ee,R,L,k)),Me,Le,Ee,je=U,ut=G(m.width*Pt),Je=!1,ft=null,pt=null,ot=null,Ut=null;u!=null&&(ut==0||d!=null)&&(Je=!0,ft=u.values(f,g,b,p),pt=new Map,new Set(ft).forEach(ue=>{ue!=null&&pt.set(ue,new Path2D)}),ut>0&&(ot=d.values(f,g,b,p),Ut=new Map,new Set(ot).forEach(ue=>{ue!=null&&Ut.set(ue,new Path2D)})));let{x0:Lt,size:Wt}=c;if(Lt!=null&&Wt!=null){X=1,v=Lt.values(f,g,b,p),Lt.unit==2&&(v=v.map(Ue=>f.posToVal(A+Ue*U,M.key,!0)));let ue=Wt.values(f,g,b,p);Wt.unit==2?Le=ue[0]*U:Le=E(ue[0],M,U,A)-E(0,M,U,A),je=hp(v,C,E,M,U,A,je),Ee=je-Le+D}else je=hp(v,C,E,M,U,A,je),Ee=je*o+D,Le=je-Ee;Ee<1&&(Ee=0),ut>=Le/2&&(ut=0),Ee<5&&(G=yp);let K=Ee>0,de=je-Ee-(K?ut:0);Le=G(iu(de,Y,V)),Me=(X==0?Le/2:X==q?0:Le)-X*q*((X==0?D/2:0)+(K?ut/2:0));let xe={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Se=Je?null:new Path2D,_e=null;if(pe!=null)_e=f.data[pe.series[1]];else{let{y0:ue,y1:ke}=c;ue!=null&&ke!=null&&(C=ke.values(f,g,b,p),_e=ue.values(f,g,b,p))}let $e=H*Le,P=ce*Le;for(let ue=q==1?b:p;ue>=b&&ue<=p;ue+=q){let ke=C[ue];if(ke==null)continue;if(_e!=null){let B=_e[ue]??0;if(ke-B==0)continue;ge=y(B,R,L,k)}let Ue=M.distr!=2||c!=null?v[ue]:ue,ye=E(Ue,M,U,A),Xe=y(Et(ke,ee),R,L,k),Te=G(ye-Me),Ge=G(Gn(Xe,ge)),T=G(Si(Xe,ge)),x=Ge-T;if(ke!=null){let B=ke<0?P:$e,se=ke<0?$e:P;Je?(ut>0&&ot[ue]!=null&&j(Ut.get(ot[ue]),Te,T+si(ut/2),Le,Gn(0,x-ut),B,se),ft[ue]!=null&&j(pt.get(ft[ue]),Te,T+si(ut/2),Le,Gn(0,x-ut),B,se)):j(Se,Te,T+si(ut/2),Le,Gn(0,x-ut),B,se),ie(f,g,ue,Te-ut/2,T,Le+ut,x)}}return ut>0?xe.stroke=Je?Ut:Se:Je||(xe._fill=m.width==0?m._fill:m._stroke??m._fill,xe.width=0),xe.fill=Je?pt:Se,xe})}function Wx(i,e){let t=Et(e?.alignGaps,0);return(n,s,r,o)=>er(n,s,(a,l,c,h,u,d,f,g,b,p,m)=>{[r,o]=ja(c,r,o);let v=a.pxRound,C=H=>v(d(H,h,p,g)),M=H=>v(f(H,u,m,b)),R,E,y;h.ori==0?(R=il,y=Ur,E=Yp):(R=sl,y=Or,E=qp);let A=h.dir*(h.ori==0?1:-1),k=C(l[A==1?r:o]),U=k,L=[],G=[];for(let H=A==1?r:o;H>=r&&H<=o;H+=A)if(c[H]!=null){let q=l[H],j=C(q);L.push(U=j),G.push(M(c[H]))}let X={stroke:i(L,G,R,y,E,v),fill:null,clip:null,band:null,gaps:null,flags:Dr},D=X.stroke,[V,Y]=vu(n,s);if(a.fill!=null||V!=0){let H=X.fill=new Path2D(D),ce=a.fillTo(n,s,a.min,a.max,V),q=M(ce);y(H,U,q),y(H,k,q)}if(!a.spanGaps){let H=[];H.push(...bu(l,c,r,o,A,C,t)),X.gaps=H=a.gaps(n,s,r,o,H),X.clip=nl(H,h.ori,g,b,p,m)}return Y!=0&&(X.band=Y==2?[ss(n,s,r,o,D,-1),ss(n,s,r,o,D,1)]:ss(n,s,r,o,D,Y)),X})}function Xx(i){return Wx(Yx,i)}function Yx(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var au=new Set;function up(){for(let i of au)i.syncRect(!0)}Nr&&(js(A_,Rr,up),js(E_,Rr,up,!0),js(Za,Rr,()=>{_n.pxRatio=Pt}));var qx=Jp(),$x=$p();function dp(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>lu(r,o,e,t))}function Zx(i,e){return i.map((t,n)=>n==0?{}:dn({},e,t))}function lu(i,e,t,n){return dn({},e==0?t:n,i)}function Kp(i,e,t){return e==null?Ir:[e,t]}var Jx=Kp;function Kx(i,e,t){return e==null?Ir:Ja(e,t,fu,!0)}function jp(i,e,t,n){return e==null?Ir:Qa(e,t,i.scales[n].log,!1)}var jx=jp;function Qp(i,e,t,n){return e==null?Ir:du(e,t,i.scales[n].log,!1)}var Qx=Qp;function ey(i,e,t,n,s){let r=Gn(Wf(i),Wf(e)),o=e-i,a=Mi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Ps.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function fp(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=mn((t=+s)*Pt))+"px"),[i,e,t]}function ty(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ht(e[2]*Pt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function _n(i,e,t){let n={mode:Et(i.mode,1)},s=n.mode;function r(_,S,I,N){let W=S.valToPct(_);return N+I*(S.dir==-1?1-W:W)}function o(_,S,I,N){let W=S.valToPct(_);return N+I*(S.dir==-1?W:1-W)}function a(_,S,I,N){return S.ori==0?r(_,S,I,N):o(_,S,I,N)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=fi(l_);if(i.id!=null&&(c.id=i.id),ii(c,i.class),i.title){let _=fi(u_,c);_.textContent=i.title}let h=bi("canvas"),u=n.ctx=h.getContext("2d"),d=fi(d_,c);js("click",d,_=>{_.target===g&&(Xt!=Mr||Jt!=Sr)&&Pn.click(n,_)},!0);let f=n.under=fi(f_,d);d.appendChild(h);let g=n.over=fi(p_,d);i=Lr(i);let b=+Et(i.pxAlign,1),p=cp(b);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,v=n.series=s==1?dp(i.series||[],np,ap,!1):Zx(i.series||[null],op),C=n.axes=dp(i.axes||[],tp,sp,!0),M=n.scales={},R=n.bands=i.bands||[];R.forEach(_=>{_.fill=wt(_.fill||null),_.dir=Et(_.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,y={axes:ts,series:yt},A=(i.drawOrder||["axes","series"]).map(_=>y[_]);function k(_){let S=_.distr==3?I=>is(I>0?I:_.clamp(n,I,_.min,_.max,_.key)):_.distr==4?I=>Zh(I,_.asinh):_.distr==100?I=>_.fwd(I):I=>I;return I=>{let N=S(I),{_min:W,_max:J}=_,fe=J-W;return(N-W)/fe}}function U(_){let S=M[_];if(S==null){let I=(i.scales||ko)[_]||ko;if(I.from!=null){U(I.from);let N=dn({},M[I.from],I,{key:_});N.valToPct=k(N),M[_]=N}else{S=M[_]=dn({},_==E?Gp:Fx,I),S.key=_;let N=S.time,W=S.range,J=Rs(W);if((_!=E||s==2&&!N)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Gf:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Gf:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&tl(W))){let fe=W;W=(we,Ie,He)=>Ie==null?Ir:Ja(Ie,He,fe)}S.range=wt(W||(N?Jx:_==E?S.distr==3?jx:S.distr==4?Qx:Kp:S.distr==3?jp:S.distr==4?Qp:Kx)),S.auto=wt(J?!1:S.auto),S.clamp=wt(S.clamp||Ox),S._min=S._max=null,S.valToPct=k(S)}}}U("x"),U("y"),s==1&&v.forEach(_=>{U(_.scale)}),C.forEach(_=>{U(_.scale)});for(let _ in i.scales)U(_);let L=M[E],G=L.distr,X,D;L.ori==0?(ii(c,c_),X=r,D=o):(ii(c,h_),X=o,D=r);let V={};for(let _ in M){let S=M[_];(S.min!=null||S.max!=null)&&(V[_]={min:S.min,max:S.max},S.min=S.max=null)}let Y=i.tzDate||(_=>new Date(mn(_/m))),H=i.fmtDate||gu,ce=m==1?cx(Y):dx(Y),q=jf(Y,Kf(m==1?lx:ux,H)),j=ep(Y,Qf(px,H)),ie=[],pe=n.legend=dn({},_x,i.legend),he=n.cursor=dn({},Sx,{drag:{y:s==2}},i.cursor),ee=pe.show,ge=he.show,Me=pe.markers;pe.idxs=ie,Me.width=wt(Me.width),Me.dash=wt(Me.dash),Me.stroke=wt(Me.stroke),Me.fill=wt(Me.fill);let Le,Ee,je,ut=[],Je=[],ft,pt=!1,ot={};if(pe.live){let _=v[1]?v[1].values:null;pt=_!=null,ft=pt?_(n,1,0):{_:0};for(let S in ft)ot[S]=hu}if(ee)if(Le=bi("table",v_,c),je=bi("tbody",null,Le),pe.mount(n,Le),pt){Ee=bi("thead",null,Le,je);let _=bi("tr",null,Ee);bi("th",null,_);for(var Ut in ft)bi("th",Cf,_).textContent=Ut}else ii(Le,M_),pe.live&&ii(Le,b_);let Lt={show:!0},Wt={show:!1};function K(_,S){if(S==0&&(pt||!pe.live||s==2))return Ir;let I=[],N=bi("tr",S_,je,je.childNodes[S]);ii(N,_.class),_.show||ii(N,Ks);let W=bi("th",null,N);if(Me.show){let we=fi(w_,W);if(S>0){let Ie=Me.width(n,S);Ie&&(we.style.border=Ie+"px "+Me.dash(n,S)+" "+Me.stroke(n,S)),we.style.background=Me.fill(n,S)}}let J=fi(Cf,W);_.label instanceof HTMLElement?J.appendChild(_.label):J.textContent=_.label,S>0&&(Me.show||(J.style.color=_.width>0?Me.stroke(n,S):Me.fill(n,S)),xe("click",W,we=>{if(he._lock)return;st(we);let Ie=v.indexOf(_);if((we.ctrlKey||we.metaKey)!=pe.isolate){let He=v.some((Ve,Ye)=>Ye>0&&Ye!=Ie&&Ve.show);v.forEach((Ve,Ye)=>{Ye>0&&Fi(Ye,He?Ye==Ie?Lt:Wt:Lt,!0,un.setSeries)})}else Fi(Ie,{show:!_.show},!0,un.setSeries)},!1),tt&&xe(Lf,W,we=>{he._lock||(st(we),Fi(v.indexOf(_),Tr,!0,un.setSeries))},!1));for(var fe in ft){let we=bi("td",T_,N);we.textContent="--",I.push(we)}return[N,I]}let de=new Map;function xe(_,S,I,N=!0){let W=de.get(S)||{},J=he.bind[_](n,S,I,N);J&&(js(_,S,W[_]=J),de.set(S,W))}function Se(_,S,I){let N=de.get(S)||{};for(let W in N)(_==null||W==_)&&(nu(W,S,N[W]),delete N[W]);_==null&&de.delete(S)}let _e=0,$e=0,P=0,ue=0,ke=0,Ue=0,ye=ke,Xe=Ue,Te=P,Ge=ue,T=0,x=0,B=0,se=0;n.bbox={};let Q=!1,me=!1,ve=!1,te=!1,re=!1,be=!1;function O(_,S,I){(I||_!=n.width||S!=n.height)&&ae(_,S),gt(!1),ve=!0,me=!0,Ln()}function ae(_,S){n.width=_e=P=_,n.height=$e=ue=S,ke=Ue=0,Re(),Qe();let I=n.bbox;T=I.left=Zs(ke*Pt,.5),x=I.top=Zs(Ue*Pt,.5),B=I.width=Zs(P*Pt,.5),se=I.height=Zs(ue*Pt,.5)}let oe=3;function Pe(){let _=!1,S=0;for(;!_;){S++;let I=yr(S),N=Oi(S);_=S==oe||I&&N,_||(ae(n.width,n.height),me=!0)}}function Ae({width:_,height:S}){O(_,S)}n.setSize=Ae;function Re(){let _=!1,S=!1,I=!1,N=!1;C.forEach((W,J)=>{if(W.show&&W._show){let{side:fe,_size:we}=W,Ie=fe%2,He=W.label!=null?W.labelSize:0,Ve=we+He;Ve>0&&(Ie?(P-=Ve,fe==3?(ke+=Ve,N=!0):I=!0):(ue-=Ve,fe==0?(Ue+=Ve,_=!0):S=!0))}}),Ni[0]=_,Ni[1]=I,Ni[2]=S,Ni[3]=N,P-=xi[1]+xi[3],ke+=xi[3],ue-=xi[2]+xi[0],Ue+=xi[0]}function Qe(){let _=ke+P,S=Ue+ue,I=ke,N=Ue;function W(J,fe){switch(J){case 1:return _+=fe,_-fe;case 2:return S+=fe,S-fe;case 3:return I-=fe,I+fe;case 0:return N-=fe,N+fe}}C.forEach((J,fe)=>{if(J.show&&J._show){let we=J.side;J._pos=W(we,J._size),J.label!=null&&(J._lpos=W(we,J.labelSize))}})}if(he.dataIdx==null){let _=he.hover,S=_.skip=new Set(_.skip??[]);S.add(void 0);let I=_.prox=wt(_.prox),N=_.bias??=0;he.dataIdx=(W,J,fe,we)=>{if(J==0)return fe;let Ie=fe,He=I(W,J,fe,we)??Gt,Ve=He>=0&&He<Gt,Ye=L.ori==0?P:ue,mt=he.left,Rt=e[0],At=e[J];if(S.has(At[fe])){Ie=null;let Mt=null,ct=null,it;if(N==0||N==-1)for(it=fe;Mt==null&&it-- >0;)S.has(At[it])||(Mt=it);if(N==0||N==1)for(it=fe;ct==null&&it++<At.length;)S.has(At[it])||(ct=it);if(Mt!=null||ct!=null)if(Ve){let qt=Mt==null?-1/0:X(Rt[Mt],L,Ye,0),tn=ct==null?1/0:X(Rt[ct],L,Ye,0),Tn=mt-qt,kt=tn-mt;Tn<=kt?Tn<=He&&(Ie=Mt):kt<=He&&(Ie=ct)}else Ie=ct==null?Mt:Mt==null?ct:fe-Mt<=ct-fe?Mt:ct}else Ve&&gn(mt-X(Rt[fe],L,Ye,0))>He&&(Ie=null);return Ie}}let st=_=>{he.event=_};he.idxs=ie,he._lock=!1;let le=he.points;le.show=wt(le.show),le.size=wt(le.size),le.stroke=wt(le.stroke),le.width=wt(le.width),le.fill=wt(le.fill);let Fe=n.focus=dn({},i.focus||{alpha:.3},he.focus),tt=Fe.prox>=0,Ce=tt&&le.one,lt=[],zt=[],In=[];function Eo(_,S){let I=le.show(n,S);if(I instanceof HTMLElement)return ii(I,y_),ii(I,_.class),Gi(I,-10,-10,P,ue),g.insertBefore(I,lt[S]),I}function gr(_,S){if(s==1||S>0){let I=s==1&&M[_.scale].time,N=_.value;_.value=I?qf(N)?ep(Y,Qf(N,H)):N||j:N||Dx,_.label=_.label||(I?Tx:wx)}if(Ce||S>0){_.width=_.width==null?1:_.width,_.paths=_.paths||qx||F_,_.fillTo=wt(_.fillTo||Bx),_.pxAlign=+Et(_.pxAlign,b),_.pxRound=cp(_.pxAlign),_.stroke=wt(_.stroke||null),_.fill=wt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let I=Nx(Gn(1,_.width),1),N=_.points=dn({},{size:I,width:Gn(1,I*.2),stroke:_.stroke,space:I*2,paths:$x,_stroke:null,_fill:null},_.points);N.show=wt(N.show),N.filter=wt(N.filter),N.fill=wt(N.fill),N.stroke=wt(N.stroke),N.paths=wt(N.paths),N.pxAlign=_.pxAlign}if(ee){let I=K(_,S);ut.splice(S,0,I[0]),Je.splice(S,0,I[1]),pe.values.push(null)}if(ge){ie.splice(S,0,null);let I=null;Ce?S==0&&(I=Eo(_,S)):S>0&&(I=Eo(_,S)),lt.splice(S,0,I),zt.splice(S,0,0),In.splice(S,0,0)}wn("addSeries",S)}function Oh(_,S){S=S??v.length,_=s==1?lu(_,S,np,ap):lu(_,S,{},op),v.splice(S,0,_),gr(v[S],S)}n.addSeries=Oh;function Ga(_){if(v.splice(_,1),ee){pe.values.splice(_,1),Je.splice(_,1);let S=ut.splice(_,1)[0];Se(null,S.firstChild),S.remove()}ge&&(ie.splice(_,1),lt.splice(_,1)[0].remove(),zt.splice(_,1),In.splice(_,1)),wn("delSeries",_)}n.delSeries=Ga;let Ni=[!1,!1,!1,!1];function ji(_,S){if(_._show=_.show,_.show){let I=_.side%2,N=M[_.scale];N==null&&(_.scale=I?v[1].scale:E,N=M[_.scale]);let W=N.time;_.size=wt(_.size),_.space=wt(_.space),_.rotate=wt(_.rotate),Rs(_.incrs)&&_.incrs.forEach(fe=>{!Ps.has(fe)&&Ps.set(fe,Mp(fe))}),_.incrs=wt(_.incrs||(N.distr==2?rx:W?m==1?ax:hx:Js)),_.splits=wt(_.splits||(W&&N.distr==1?ce:N.distr==3?su:N.distr==4?Cx:Ex)),_.stroke=wt(_.stroke),_.grid.stroke=wt(_.grid.stroke),_.ticks.stroke=wt(_.ticks.stroke),_.border.stroke=wt(_.border.stroke);let J=_.values;_.values=Rs(J)&&!Rs(J[0])?wt(J):W?Rs(J)?jf(Y,Kf(J,H)):qf(J)?fx(Y,J):J||q:J||Ax,_.filter=wt(_.filter||(N.distr>=3&&N.log==10?Ix:N.distr==3&&N.log==2?Lx:vp)),_.font=fp(_.font),_.labelFont=fp(_.labelFont),_._size=_.size(n,null,S,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Ni[S]=!0,_._el=fi(m_,d))}}function Qi(_,S,I,N){let[W,J,fe,we]=I,Ie=S%2,He=0;return Ie==0&&(we||J)&&(He=S==0&&!W||S==2&&!fe?mn(tp.size/3):0),Ie==1&&(W||fe)&&(He=S==1&&!J||S==3&&!we?mn(sp.size/2):0),He}let Co=n.padding=(i.padding||[Qi,Qi,Qi,Qi]).map(_=>wt(Et(_,Qi))),xi=n._padding=Co.map((_,S)=>_(n,S,Ni,0)),Qt,sn=null,rn=null,Ui=s==1?v[0].idxs:null,Qn=null,Ss=!1;function Ro(_,S){if(e=_??[],n.data=n._data=e,s==2){Qt=0;for(let I=1;I<v.length;I++)Qt+=e[I][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),Qn=e[0],Qt=Qn.length;let I=e;if(G==2){I=e.slice();let N=I[0]=Array(Qt);for(let W=0;W<Qt;W++)N[W]=W}n._data=e=I}if(gt(!0),wn("setData"),G==2&&(ve=!0),S!==!1){let I=L;I.auto(n,Ss)?Po():As(E,I.min,I.max),te=te||he.left>=0,be=!0,Ln()}}n.setData=Ro;function Po(){Ss=!0;let _,S;s==1&&(Qt>0?(sn=Ui[0]=0,rn=Ui[1]=Qt-1,_=e[0][sn],S=e[0][rn],G==2?(_=sn,S=rn):_==S&&(G==3?[_,S]=Qa(_,_,L.log,!1):G==4?[_,S]=du(_,_,L.log,!1):L.time?S=_+mn(86400/m):[_,S]=Ja(_,S,fu,!0))):(sn=Ui[0]=_=null,rn=Ui[1]=S=null)),As(E,_,S)}let _r,ws,xr,w,z,ne,$,Z,De,Oe;function Ne(_,S,I,N,W,J){_??=Pf,I??=mu,N??="butt",W??=Pf,J??="round",_!=_r&&(u.strokeStyle=_r=_),W!=ws&&(u.fillStyle=ws=W),S!=xr&&(u.lineWidth=xr=S),J!=z&&(u.lineJoin=z=J),N!=ne&&(u.lineCap=ne=N),I!=w&&u.setLineDash(w=I)}function Be(_,S,I,N){S!=ws&&(u.fillStyle=ws=S),_!=$&&(u.font=$=_),I!=Z&&(u.textAlign=Z=I),N!=De&&(u.textBaseline=De=N)}function Ke(_,S,I,N,W=0){if(N.length>0&&_.auto(n,Ss)&&(S==null||S.min==null)){let J=Et(sn,0),fe=Et(rn,N.length-1),we=I.min==null?I_(N,J,fe,W,_.distr==3):[I.min,I.max];_.min=Si(_.min,I.min=we[0]),_.max=Gn(_.max,I.max=we[1])}}let dt={min:null,max:null};function xt(){for(let N in M){let W=M[N];V[N]==null&&(W.min==null||V[E]!=null&&W.auto(n,Ss))&&(V[N]=dt)}for(let N in M){let W=M[N];V[N]==null&&W.from!=null&&V[W.from]!=null&&(V[N]=dt)}V[E]!=null&&gt(!0);let _={};for(let N in V){let W=V[N];if(W!=null){let J=_[N]=Lr(M[N],k_);if(W.min!=null)dn(J,W);else if(N!=E||s==2)if(Qt==0&&J.from==null){let fe=J.range(n,null,null,N);J.min=fe[0],J.max=fe[1]}else J.min=Gt,J.max=-Gt}}if(Qt>0){v.forEach((N,W)=>{if(s==1){let J=N.scale,fe=V[J];if(fe==null)return;let we=_[J];if(W==0){let Ie=we.range(n,we.min,we.max,J);we.min=Ie[0],we.max=Ie[1],sn=Mi(we.min,e[0]),rn=Mi(we.max,e[0]),rn-sn>1&&(e[0][sn]<we.min&&sn++,e[0][rn]>we.max&&rn--),N.min=Qn[sn],N.max=Qn[rn]}else N.show&&N.auto&&Ke(we,fe,N,e[W],N.sorted);N.idxs[0]=sn,N.idxs[1]=rn}else if(W>0&&N.show&&N.auto){let[J,fe]=N.facets,we=J.scale,Ie=fe.scale,[He,Ve]=e[W],Ye=_[we],mt=_[Ie];Ye!=null&&Ke(Ye,V[we],J,He,J.sorted),mt!=null&&Ke(mt,V[Ie],fe,Ve,fe.sorted),N.min=fe.min,N.max=fe.max}});for(let N in _){let W=_[N],J=V[N];if(W.from==null&&(J==null||J.min==null)){let fe=W.range(n,W.min==Gt?null:W.min,W.max==-Gt?null:W.max,N);W.min=fe[0],W.max=fe[1]}}}for(let N in _){let W=_[N];if(W.from!=null){let J=_[W.from];if(J.min==null)W.min=W.max=null;else{let fe=W.range(n,J.min,J.max,N);W.min=fe[0],W.max=fe[1]}}}let S={},I=!1;for(let N in _){let W=_[N],J=M[N];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let fe=J.distr;J._min=fe==3?is(J.min):fe==4?Zh(J.min,J.asinh):fe==100?J.fwd(J.min):J.min,J._max=fe==3?is(J.max):fe==4?Zh(J.max,J.asinh):fe==100?J.fwd(J.max):J.max,S[N]=I=!0}}if(I){v.forEach((N,W)=>{s==2?W>0&&S.y&&(N._paths=null):S[N.scale]&&(N._paths=null)});for(let N in S)ve=!0,wn("setScale",N);ge&&he.left>=0&&(te=be=!0)}for(let N in V)V[N]=null}function Ze(_){let S=iu(sn-1,0,Qt-1),I=iu(rn+1,0,Qt-1);for(;_[S]==null&&S>0;)S--;for(;_[I]==null&&I<Qt-1;)I++;return[S,I]}function yt(){if(Qt>0){let _=v.some(S=>S._focus)&&Oe!=Fe.alpha;_&&(u.globalAlpha=Oe=Fe.alpha),v.forEach((S,I)=>{if(I>0&&S.show&&(Kt(I,!1),Kt(I,!0),S._paths==null)){let N=Oe;Oe!=S.alpha&&(u.globalAlpha=Oe=S.alpha);let W=s==2?[0,e[I][0].length-1]:Ze(e[I]);S._paths=S.paths(n,I,W[0],W[1]),Oe!=N&&(u.globalAlpha=Oe=N)}}),v.forEach((S,I)=>{if(I>0&&S.show){let N=Oe;Oe!=S.alpha&&(u.globalAlpha=Oe=S.alpha),S._paths!=null&&Ot(I,!1);{let W=S._paths!=null?S._paths.gaps:null,J=S.points.show(n,I,sn,rn,W),fe=S.points.filter(n,I,J,W);(J||fe)&&(S.points._paths=S.points.paths(n,I,sn,rn,fe),Ot(I,!0))}Oe!=N&&(u.globalAlpha=Oe=N),wn("drawSeries",I)}}),_&&(u.globalAlpha=Oe=1)}}function Kt(_,S){let I=S?v[_].points:v[_];I._stroke=I.stroke(n,_),I._fill=I.fill(n,_)}function Ot(_,S){let I=S?v[_].points:v[_],{stroke:N,fill:W,clip:J,flags:fe,_stroke:we=I._stroke,_fill:Ie=I._fill,_width:He=I.width}=I._paths;He=Ht(He*Pt,3);let Ve=null,Ye=He%2/2;S&&Ie==null&&(Ie=He>0?"#fff":we);let mt=I.pxAlign==1&&Ye>0;if(mt&&u.translate(Ye,Ye),!S){let Rt=T-He/2,At=x-He/2,Mt=B+He,ct=se+He;Ve=new Path2D,Ve.rect(Rt,At,Mt,ct)}S?We(we,He,I.dash,I.cap,Ie,N,W,fe,J):Ft(_,we,He,I.dash,I.cap,Ie,N,W,fe,Ve,J),mt&&u.translate(-Ye,-Ye)}function Ft(_,S,I,N,W,J,fe,we,Ie,He,Ve){let Ye=!1;Ie!=0&&R.forEach((mt,Rt)=>{if(mt.series[0]==_){let At=v[mt.series[1]],Mt=e[mt.series[1]],ct=(At._paths||ko).band;Rs(ct)&&(ct=mt.dir==1?ct[0]:ct[1]);let it,qt=null;At.show&&ct&&D_(Mt,sn,rn)?(qt=mt.fill(n,Rt)||J,it=At._paths.clip):ct=null,We(S,I,N,W,qt,fe,we,Ie,He,Ve,it,ct),Ye=!0}}),Ye||We(S,I,N,W,J,fe,we,Ie,He,Ve)}let pn=Dr|ou;function We(_,S,I,N,W,J,fe,we,Ie,He,Ve,Ye){Ne(_,S,I,N,W),(Ie||He||Ye)&&(u.save(),Ie&&u.clip(Ie),He&&u.clip(He)),Ye?(we&pn)==pn?(u.clip(Ye),Ve&&u.clip(Ve),St(W,fe),ln(_,J,S)):we&ou?(St(W,fe),u.clip(Ye),ln(_,J,S)):we&Dr&&(u.save(),u.clip(Ye),Ve&&u.clip(Ve),St(W,fe),u.restore(),ln(_,J,S)):(St(W,fe),ln(_,J,S)),(Ie||He||Ye)&&u.restore()}function ln(_,S,I){I>0&&(S instanceof Map?S.forEach((N,W)=>{u.strokeStyle=_r=W,u.stroke(N)}):S!=null&&_&&u.stroke(S))}function St(_,S){S instanceof Map?S.forEach((I,N)=>{u.fillStyle=ws=N,u.fill(I)}):S!=null&&_&&u.fill(S)}function es(_,S,I,N){let W=C[_],J;if(N<=0)J=[0,0];else{let fe=W._space=W.space(n,_,S,I,N),we=W._incrs=W.incrs(n,_,S,I,N,fe);J=ey(S,I,we,N,fe)}return W._found=J}function cn(_,S,I,N,W,J,fe,we,Ie,He){let Ve=fe%2/2;b==1&&u.translate(Ve,Ve),Ne(we,fe,Ie,He,we),u.beginPath();let Ye,mt,Rt,At,Mt=W+(N==0||N==3?-J:J);I==0?(mt=W,At=Mt):(Ye=W,Rt=Mt);for(let ct=0;ct<_.length;ct++)S[ct]!=null&&(I==0?Ye=Rt=_[ct]:mt=At=_[ct],u.moveTo(Ye,mt),u.lineTo(Rt,At));u.stroke(),b==1&&u.translate(-Ve,-Ve)}function yr(_){let S=!0;return C.forEach((I,N)=>{if(!I.show)return;let W=M[I.scale];if(W.min==null){I._show&&(S=!1,I._show=!1,gt(!1));return}else I._show||(S=!1,I._show=!0,gt(!1));let J=I.side,fe=J%2,{min:we,max:Ie}=W,[He,Ve]=es(N,we,Ie,fe==0?P:ue);if(Ve==0)return;let Ye=W.distr==2,mt=I._splits=I.splits(n,N,we,Ie,He,Ve,Ye),Rt=W.distr==2?mt.map(it=>Qn[it]):mt,At=W.distr==2?Qn[mt[1]]-Qn[mt[0]]:He,Mt=I._values=I.values(n,I.filter(n,Rt,N,Ve,At),N,Ve,At);I._rotate=J==2?I.rotate(n,Mt,N,Ve):0;let ct=I._size;I._size=pi(I.size(n,Mt,N,_)),ct!=null&&I._size!=ct&&(S=!1)}),S}function Oi(_){let S=!0;return Co.forEach((I,N)=>{let W=I(n,N,Ni,_);W!=xi[N]&&(S=!1),xi[N]=W}),S}function ts(){for(let _=0;_<C.length;_++){let S=C[_];if(!S.show||!S._show)continue;let I=S.side,N=I%2,W,J,fe=S.stroke(n,_),we=I==0||I==3?-1:1,[Ie,He]=S._found;if(S.label!=null){let zn=S.labelGap*we,ni=mn((S._lpos+zn)*Pt);Be(S.labelFont[0],fe,"center",I==2?"top":Rf),u.save(),N==1?(W=J=0,u.translate(ni,mn(x+se/2)),u.rotate((I==3?-$a:$a)/2)):(W=mn(T+B/2),J=ni);let $s=xp(S.label)?S.label(n,_,Ie,He):S.label;u.fillText($s,W,J),u.restore()}if(He==0)continue;let Ve=M[S.scale],Ye=N==0?B:se,mt=N==0?T:x,Rt=S._splits,At=Ve.distr==2?Rt.map(zn=>Qn[zn]):Rt,Mt=Ve.distr==2?Qn[Rt[1]]-Qn[Rt[0]]:Ie,ct=S.ticks,it=S.border,qt=ct.show?ct.size:0,tn=mn(qt*Pt),Tn=mn((S.alignTo==2?S._size-qt-S.gap:S.gap)*Pt),kt=S._rotate*-$a/180,nn=p(S._pos*Pt),ei=(tn+Tn)*we,Bn=nn+ei;J=N==0?Bn:0,W=N==1?Bn:0;let ui=S.font[0],yi=S.align==1?Er:S.align==2?Yh:kt>0?Er:kt<0?Yh:N==0?"center":I==3?Yh:Er,zi=kt||N==1?"middle":I==2?"top":Rf;Be(ui,fe,yi,zi);let ti=S.font[1]*S.lineGap,di=Rt.map(zn=>p(a(zn,Ve,Ye,mt))),vi=S._values;for(let zn=0;zn<vi.length;zn++){let ni=vi[zn];if(ni!=null){N==0?W=di[zn]:J=di[zn],ni=""+ni;let $s=ni.indexOf(`
`)==-1?[ni]:ni.split(/\n/gm);for(let kn=0;kn<$s.length;kn++){let Ef=$s[kn];kt?(u.save(),u.translate(W,J+kn*ti),u.rotate(kt),u.fillText(Ef,0,0),u.restore()):u.fillText(Ef,W,J+kn*ti)}}}ct.show&&cn(di,ct.filter(n,At,_,He,Mt),N,I,nn,tn,Ht(ct.width*Pt,3),ct.stroke(n,_),ct.dash,ct.cap);let ki=S.grid;ki.show&&cn(di,ki.filter(n,At,_,He,Mt),N,N==0?2:1,N==0?x:T,N==0?se:B,Ht(ki.width*Pt,3),ki.stroke(n,_),ki.dash,ki.cap),it.show&&cn([nn],[1],N==0?1:0,N==0?1:2,N==1?x:T,N==1?se:B,Ht(it.width*Pt,3),it.stroke(n,_),it.dash,it.cap)}wn("drawAxes")}function gt(_){v.forEach((S,I)=>{I>0&&(S._paths=null,_&&(s==1?(S.min=null,S.max=null):S.facets.forEach(N=>{N.min=null,N.max=null})))})}let en=!1,Fn=!1,Bt=[];function hn(){Fn=!1;for(let _=0;_<Bt.length;_++)wn(...Bt[_]);Bt.length=0}function Ln(){en||(q_(cf),en=!0)}function Ha(_,S=!1){en=!0,Fn=S,_(n),cf(),S&&Bt.length>0&&queueMicrotask(hn)}n.batch=Ha;function cf(){if(Q&&(xt(),Q=!1),ve&&(Pe(),ve=!1),me){if($t(f,Er,ke),$t(f,"top",Ue),$t(f,Oo,P),$t(f,Fo,ue),$t(g,Er,ke),$t(g,"top",Ue),$t(g,Oo,P),$t(g,Fo,ue),$t(d,Oo,_e),$t(d,Fo,$e),h.width=mn(_e*Pt),h.height=mn($e*Pt),C.forEach(({_el:_,_show:S,_size:I,_pos:N,side:W})=>{if(_!=null)if(S){let J=W===3||W===0?I:0,fe=W%2==1;$t(_,fe?"left":"top",N-J),$t(_,fe?"width":"height",I),$t(_,fe?"top":"left",fe?Ue:ke),$t(_,fe?"height":"width",fe?ue:P),tu(_,Ks)}else ii(_,Ks)}),_r=ws=xr=z=ne=$=Z=De=w=null,Oe=1,Do(!0),ke!=ye||Ue!=Xe||P!=Te||ue!=Ge){gt(!1);let _=P/Te,S=ue/Ge;if(ge&&!te&&he.left>=0){he.left*=_,he.top*=S,vr&&Gi(vr,mn(he.left),0,P,ue),br&&Gi(br,0,mn(he.top),P,ue);for(let I=0;I<lt.length;I++){let N=lt[I];N!=null&&(zt[I]*=_,In[I]*=S,Gi(N,pi(zt[I]),pi(In[I]),P,ue))}}if(Yt.show&&!re&&Yt.left>=0&&Yt.width>0){Yt.left*=_,Yt.width*=_,Yt.top*=S,Yt.height*=S;for(let I in Hh)$t(wr,I,Yt[I])}ye=ke,Xe=Ue,Te=P,Ge=ue}wn("setSize"),me=!1}_e>0&&$e>0&&(u.clearRect(0,0,h.width,h.height),wn("drawClear"),A.forEach(_=>_()),wn("draw")),Yt.show&&re&&(Va(Yt),re=!1),ge&&te&&(qs(null,!0,!1),te=!1),pe.show&&pe.live&&be&&(kh(),be=!1),l||(l=!0,n.status=1,wn("ready")),Ss=!1,en=!1}n.redraw=(_,S)=>{ve=S||!1,_!==!1?As(E,L.min,L.max):Ln()};function Fh(_,S){let I=M[_];if(I.from==null){if(Qt==0){let N=I.range(n,S.min,S.max,_);S.min=N[0],S.max=N[1]}if(S.min>S.max){let N=S.min;S.min=S.max,S.max=N}if(Qt>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;_==E&&I.distr==2&&Qt>0&&(S.min=Mi(S.min,e[0]),S.max=Mi(S.max,e[0]),S.min==S.max&&S.max++),V[_]=S,Q=!0,Ln()}}n.setScale=Fh;let Bh,zh,vr,br,hf,uf,Mr,Sr,df,ff,Xt,Jt,Ts=!1,Pn=he.drag,Mn=Pn.x,Sn=Pn.y;ge&&(he.x&&(Bh=fi(__,g)),he.y&&(zh=fi(x_,g)),L.ori==0?(vr=Bh,br=zh):(vr=zh,br=Bh),Xt=he.left,Jt=he.top);let Yt=n.select=dn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),wr=Yt.show?fi(g_,Yt.over?g:f):null;function Va(_,S){if(Yt.show){for(let I in _)Yt[I]=_[I],I in Hh&&$t(wr,I,_[I]);S!==!1&&wn("setSelect")}}n.setSelect=Va;function J0(_){if(v[_].show)ee&&tu(ut[_],Ks);else if(ee&&ii(ut[_],Ks),ge){let I=Ce?lt[0]:lt[_];I!=null&&Gi(I,-10,-10,P,ue)}}function As(_,S,I){Fh(_,{min:S,max:I})}function Fi(_,S,I,N){S.focus!=null&&t_(_),S.show!=null&&v.forEach((W,J)=>{J>0&&(_==J||_==null)&&(W.show=S.show,J0(J),s==2?(As(W.facets[0].scale,null,null),As(W.facets[1].scale,null,null)):As(W.scale,null,null),Ln())}),I!==!1&&wn("setSeries",_,S),N&&No("setSeries",n,_,S)}n.setSeries=Fi;function K0(_,S){dn(R[_],S)}function j0(_,S){_.fill=wt(_.fill||null),_.dir=Et(_.dir,-1),S=S??R.length,R.splice(S,0,_)}function Q0(_){_==null?R.length=0:R.splice(_,1)}n.addBand=j0,n.setBand=K0,n.delBand=Q0;function e_(_,S){v[_].alpha=S,ge&&lt[_]!=null&&(lt[_].style.opacity=S),ee&&ut[_]&&(ut[_].style.opacity=S)}let ns,Es,Ys,Tr={focus:!0};function t_(_){if(_!=Ys){let S=_==null,I=Fe.alpha!=1;v.forEach((N,W)=>{if(s==1||W>0){let J=S||W==0||W==_;N._focus=S?null:J,I&&e_(W,J?1:Fe.alpha)}}),Ys=_,I&&Ln()}}ee&&tt&&xe(Df,Le,_=>{he._lock||(st(_),Ys!=null&&Fi(null,Tr,!0,un.setSeries))});function Bi(_,S,I){let N=M[S];I&&(_=_/Pt-(N.ori==1?Ue:ke));let W=P;N.ori==1&&(W=ue,_=W-_),N.dir==-1&&(_=W-_);let J=N._min,fe=N._max,we=_/W,Ie=J+(fe-J)*we,He=N.distr;return He==3?Pr(10,Ie):He==4?U_(Ie,N.asinh):He==100?N.bwd(Ie):Ie}function n_(_,S){let I=Bi(_,E,S);return Mi(I,e[0],sn,rn)}n.valToIdx=_=>Mi(_,e[0]),n.posToIdx=n_,n.posToVal=Bi,n.valToPos=(_,S,I)=>M[S].ori==0?r(_,M[S],I?B:P,I?T:0):o(_,M[S],I?se:ue,I?x:0),n.setCursor=(_,S,I)=>{Xt=_.left,Jt=_.top,qs(null,S,I)};function pf(_,S){$t(wr,Er,Yt.left=_),$t(wr,Oo,Yt.width=S)}function mf(_,S){$t(wr,"top",Yt.top=_),$t(wr,Fo,Yt.height=S)}let Io=L.ori==0?pf:mf,Lo=L.ori==1?pf:mf;function i_(){if(ee&&pe.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&pt)continue;let S=pe.values[_],I=0;for(let N in S)Je[_][I++].firstChild.nodeValue=S[N]}}function kh(_,S){if(_!=null&&(_.idxs?_.idxs.forEach((I,N)=>{ie[N]=I}):z_(_.idx)||ie.fill(_.idx),pe.idx=ie[0]),ee&&pe.live){for(let I=0;I<v.length;I++)(I>0||s==1&&!pt)&&s_(I,ie[I]);i_()}be=!1,S!==!1&&wn("setLegend")}n.setLegend=kh;function s_(_,S){let I=v[_],N=_==0&&G==2?Qn:e[_],W;pt?W=I.values(n,_,S)??ot:(W=I.value(n,S==null?null:N[S],_,S),W=W==null?ot:{_:W}),pe.values[_]=W}function qs(_,S,I){df=Xt,ff=Jt,[Xt,Jt]=he.move(n,Xt,Jt),he.left=Xt,he.top=Jt,ge&&(vr&&Gi(vr,mn(Xt),0,P,ue),br&&Gi(br,0,mn(Jt),P,ue));let N,W=sn>rn;ns=Gt,Es=null;let J=L.ori==0?P:ue,fe=L.ori==1?P:ue;if(Xt<0||Qt==0||W){N=he.idx=null;for(let we=0;we<v.length;we++){let Ie=lt[we];Ie!=null&&Gi(Ie,-10,-10,P,ue)}tt&&Fi(null,Tr,!0,_==null&&un.setSeries),pe.live&&(ie.fill(N),be=!0)}else{let we,Ie,He;s==1&&(we=L.ori==0?Xt:Jt,Ie=Bi(we,E),N=he.idx=Mi(Ie,e[0],sn,rn),He=X(e[0][N],L,J,0));let Ve=-10,Ye=-10,mt=0,Rt=0,At=!0,Mt="",ct="";for(let it=s==2?1:0;it<v.length;it++){let qt=v[it],tn=ie[it],Tn=tn==null?null:s==1?e[it][tn]:e[it][1][tn],kt=he.dataIdx(n,it,N,Ie),nn=kt==null?null:s==1?e[it][kt]:e[it][1][kt];if(be=be||nn!=Tn||kt!=tn,ie[it]=kt,it>0&&qt.show){let ei=kt==null?-10:kt==N?He:X(s==1?e[0][kt]:e[it][0][kt],L,J,0),Bn=nn==null?-10:D(nn,s==1?M[qt.scale]:M[qt.facets[1].scale],fe,0);if(tt&&nn!=null){let ui=L.ori==1?Xt:Jt,yi=gn(Fe.dist(n,it,kt,Bn,ui));if(yi<ns){let zi=Fe.bias;if(zi!=0){let ti=Bi(ui,qt.scale),di=nn>=0?1:-1,vi=ti>=0?1:-1;vi==di&&(vi==1?zi==1?nn>=ti:nn<=ti:zi==1?nn<=ti:nn>=ti)&&(ns=yi,Es=it)}else ns=yi,Es=it}}if(be||Ce){let ui,yi;L.ori==0?(ui=ei,yi=Bn):(ui=Bn,yi=ei);let zi,ti,di,vi,ki,zn,ni=!0,$s=le.bbox;if($s!=null){ni=!1;let kn=$s(n,it);di=kn.left,vi=kn.top,zi=kn.width,ti=kn.height}else di=ui,vi=yi,zi=ti=le.size(n,it);if(zn=le.fill(n,it),ki=le.stroke(n,it),Ce)it==Es&&ns<=Fe.prox&&(Ve=di,Ye=vi,mt=zi,Rt=ti,At=ni,Mt=zn,ct=ki);else{let kn=lt[it];kn!=null&&(zt[it]=di,In[it]=vi,kf(kn,zi,ti,ni),Bf(kn,zn,ki),Gi(kn,pi(di),pi(vi),P,ue))}}}}if(Ce){let it=Fe.prox,qt=Ys==null?ns<=it:ns>it||Es!=Ys;if(be||qt){let tn=lt[0];tn!=null&&(zt[0]=Ve,In[0]=Ye,kf(tn,mt,Rt,At),Bf(tn,Mt,ct),Gi(tn,pi(Ve),pi(Ye),P,ue))}}}if(Yt.show&&Ts)if(_!=null){let[we,Ie]=un.scales,[He,Ve]=un.match,[Ye,mt]=_.cursor.sync.scales,Rt=_.cursor.drag;if(Mn=Rt._x,Sn=Rt._y,Mn||Sn){let{left:At,top:Mt,width:ct,height:it}=_.select,qt=_.scales[Ye].ori,tn=_.posToVal,Tn,kt,nn,ei,Bn,ui=we!=null&&He(we,Ye),yi=Ie!=null&&Ve(Ie,mt);ui&&Mn?(qt==0?(Tn=At,kt=ct):(Tn=Mt,kt=it),nn=M[we],ei=X(tn(Tn,Ye),nn,J,0),Bn=X(tn(Tn+kt,Ye),nn,J,0),Io(Si(ei,Bn),gn(Bn-ei))):Io(0,J),yi&&Sn?(qt==1?(Tn=At,kt=ct):(Tn=Mt,kt=it),nn=M[Ie],ei=D(tn(Tn,mt),nn,fe,0),Bn=D(tn(Tn+kt,mt),nn,fe,0),Lo(Si(ei,Bn),gn(Bn-ei))):Lo(0,fe)}else Vh()}else{let we=gn(df-hf),Ie=gn(ff-uf);if(L.ori==1){let mt=we;we=Ie,Ie=mt}Mn=Pn.x&&we>=Pn.dist,Sn=Pn.y&&Ie>=Pn.dist;let He=Pn.uni;He!=null?Mn&&Sn&&(Mn=we>=He,Sn=Ie>=He,!Mn&&!Sn&&(Ie>we?Sn=!0:Mn=!0)):Pn.x&&Pn.y&&(Mn||Sn)&&(Mn=Sn=!0);let Ve,Ye;Mn&&(L.ori==0?(Ve=Mr,Ye=Xt):(Ve=Sr,Ye=Jt),Io(Si(Ve,Ye),gn(Ye-Ve)),Sn||Lo(0,fe)),Sn&&(L.ori==1?(Ve=Mr,Ye=Xt):(Ve=Sr,Ye=Jt),Lo(Si(Ve,Ye),gn(Ye-Ve)),Mn||Io(0,J)),!Mn&&!Sn&&(Io(0,0),Lo(0,0))}if(Pn._x=Mn,Pn._y=Sn,_==null){if(I){if(Af!=null){let[we,Ie]=un.scales;un.values[0]=we!=null?Bi(L.ori==0?Xt:Jt,we):null,un.values[1]=Ie!=null?Bi(L.ori==1?Xt:Jt,Ie):null}No(qh,n,Xt,Jt,P,ue,N)}if(tt){let we=I&&un.setSeries,Ie=Fe.prox;Ys==null?ns<=Ie&&Fi(Es,Tr,!0,we):ns>Ie?Fi(null,Tr,!0,we):Es!=Ys&&Fi(Es,Tr,!0,we)}}be&&(pe.idx=N,kh()),S!==!1&&wn("setCursor")}let Cs=null;Object.defineProperty(n,"rect",{get(){return Cs==null&&Do(!1),Cs}});function Do(_=!1){_?Cs=null:(Cs=g.getBoundingClientRect(),wn("syncRect",Cs))}function gf(_,S,I,N,W,J,fe){he._lock||Ts&&_!=null&&_.movementX==0&&_.movementY==0||(Gh(_,S,I,N,W,J,fe,!1,_!=null),_!=null?qs(null,!0,!0):qs(S,!0,!1))}function Gh(_,S,I,N,W,J,fe,we,Ie){if(Cs==null&&Do(!1),st(_),_!=null)I=_.clientX-Cs.left,N=_.clientY-Cs.top;else{if(I<0||N<0){Xt=-10,Jt=-10;return}let[He,Ve]=un.scales,Ye=S.cursor.sync,[mt,Rt]=Ye.values,[At,Mt]=Ye.scales,[ct,it]=un.match,qt=S.axes[0].side%2==1,tn=L.ori==0?P:ue,Tn=L.ori==1?P:ue,kt=qt?J:W,nn=qt?W:J,ei=qt?N:I,Bn=qt?I:N;if(At!=null?I=ct(He,At)?a(mt,M[He],tn,0):-10:I=tn*(ei/kt),Mt!=null?N=it(Ve,Mt)?a(Rt,M[Ve],Tn,0):-10:N=Tn*(Bn/nn),L.ori==1){let ui=I;I=N,N=ui}}Ie&&(S==null||S.cursor.event.type==qh)&&((I<=1||I>=P-1)&&(I=Zs(I,P)),(N<=1||N>=ue-1)&&(N=Zs(N,ue))),we?(hf=I,uf=N,[Mr,Sr]=he.move(n,I,N)):(Xt=I,Jt=N)}let Hh={width:0,height:0,left:0,top:0};function Vh(){Va(Hh,!1)}let _f,xf,yf,vf;function bf(_,S,I,N,W,J,fe){Ts=!0,Mn=Sn=Pn._x=Pn._y=!1,Gh(_,S,I,N,W,J,fe,!0,!1),_!=null&&(xe($h,Qh,Mf,!1),No(If,n,Mr,Sr,P,ue,null));let{left:we,top:Ie,width:He,height:Ve}=Yt;_f=we,xf=Ie,yf=He,vf=Ve}function Mf(_,S,I,N,W,J,fe){Ts=Pn._x=Pn._y=!1,Gh(_,S,I,N,W,J,fe,!1,!0);let{left:we,top:Ie,width:He,height:Ve}=Yt,Ye=He>0||Ve>0,mt=_f!=we||xf!=Ie||yf!=He||vf!=Ve;if(Ye&&mt&&Va(Yt),Pn.setScale&&Ye&&mt){let Rt=we,At=He,Mt=Ie,ct=Ve;if(L.ori==1&&(Rt=Ie,At=Ve,Mt=we,ct=He),Mn&&As(E,Bi(Rt,E),Bi(Rt+At,E)),Sn)for(let it in M){let qt=M[it];it!=E&&qt.from==null&&qt.min!=Gt&&As(it,Bi(Mt+ct,it),Bi(Mt,it))}Vh()}else he.lock&&(he._lock=!he._lock,qs(S,!0,_!=null));_!=null&&(Se($h,Qh),No($h,n,Xt,Jt,P,ue,null))}function r_(_,S,I,N,W,J,fe){if(he._lock)return;st(_);let we=Ts;if(Ts){let Ie=!0,He=!0,Ve=10,Ye,mt;L.ori==0?(Ye=Mn,mt=Sn):(Ye=Sn,mt=Mn),Ye&&mt&&(Ie=Xt<=Ve||Xt>=P-Ve,He=Jt<=Ve||Jt>=ue-Ve),Ye&&Ie&&(Xt=Xt<Mr?0:P),mt&&He&&(Jt=Jt<Sr?0:ue),qs(null,!0,!0),Ts=!1}Xt=-10,Jt=-10,ie.fill(null),qs(null,!0,!0),we&&(Ts=we)}function Sf(_,S,I,N,W,J,fe){he._lock||(st(_),Po(),Vh(),_!=null&&No(Nf,n,Xt,Jt,P,ue,null))}function wf(){C.forEach(ty),O(n.width,n.height,!0)}js(Za,Rr,wf);let Ar={};Ar.mousedown=bf,Ar.mousemove=gf,Ar.mouseup=Mf,Ar.dblclick=Sf,Ar.setSeries=(_,S,I,N)=>{let W=un.match[2];I=W(n,S,I),I!=-1&&Fi(I,N,!0,!1)},ge&&(xe(If,g,bf),xe(qh,g,gf),xe(Lf,g,_=>{st(_),Do(!1)}),xe(Df,g,r_),xe(Nf,g,Sf),au.add(n),n.syncRect=Do);let Wa=n.hooks=i.hooks||{};function wn(_,S,I){Fn?Bt.push([_,S,I]):_ in Wa&&Wa[_].forEach(N=>{N.call(null,n,S,I)})}(i.plugins||[]).forEach(_=>{for(let S in _.hooks)Wa[S]=(Wa[S]||[]).concat(_.hooks[S])});let Tf=(_,S,I)=>I,un=dn({key:null,setSeries:!1,filters:{pub:Xf,sub:Xf},scales:[E,v[1]?v[1].scale:null],match:[Yf,Yf,Tf],values:[null,null]},he.sync);un.match.length==2&&un.match.push(Tf),he.sync=un;let Af=un.key,Wh=Hp(Af);function No(_,S,I,N,W,J,fe){un.filters.pub(_,S,I,N,W,J,fe)&&Wh.pub(_,S,I,N,W,J,fe)}Wh.sub(n);function o_(_,S,I,N,W,J,fe){un.filters.sub(_,S,I,N,W,J,fe)&&Ar[_](null,S,I,N,W,J,fe)}n.pub=o_;function a_(){Wh.unsub(n),au.delete(n),de.clear(),nu(Za,Rr,wf),c.remove(),Le?.remove(),wn("destroy")}n.destroy=a_;function Xh(){wn("init",i,e),Ro(e||i.data,!1),V[E]?Fh(E,V[E]):Po(),re=Yt.show&&(Yt.width>0||Yt.height>0),te=be=!0,O(i.width,i.height)}return v.forEach(gr),C.forEach(ji),t?t instanceof HTMLElement?(t.appendChild(c),Xh()):t(n,Xh):Xh(),n}_n.assign=dn;_n.fmtNum=pu;_n.rangeNum=Ja;_n.rangeLog=Qa;_n.rangeAsinh=du;_n.orient=er;_n.pxRatio=Pt;_n.join=Y_;_n.fmtDate=gu,_n.tzDate=ix;_n.sync=Hp;{_n.addGap=zx,_n.clipGaps=nl;let i=_n.paths={points:$p};i.linear=Jp,i.stepped=Hx,i.bars=Vx,i.spline=Xx}function Hi(i,e){if(!Number.isFinite(i))return"\u2013";let t=Number(i.toPrecision(e)),n=Math.abs(t);return n!==0&&(n>=1e6||n<1e-4)?tm(t.toExponential()):`${t}`}function tm(i){return i.replace("e+","e")}function nm(i,e){let t=Math.max(...i.map(Math.abs));if(t>=1e6||e<1e-4){let r=Math.max(Math.ceil(Math.log10(t/e)-1e-9),0);return i.map(o=>o===0?"0":tm(o.toExponential(Math.min(r,15)).replace(/\.?0+e/,"e")))}let n=0;for(;Math.abs(e*10**n-Math.round(e*10**n))>1e-6;)++n;let s={minimumFractionDigits:n,maximumFractionDigits:n};return i.map(r=>(r===0?0:r).toLocaleString("en-US",s))}function Fr(i){let e=10**Math.floor(Math.log10(i));return([1,2,5].find(t=>t*e>=i*(1-1e-9))??10)*e}function ol(i,e,t){let n=i.filter(({kind:s})=>s!=="tick").map(s=>[im(s.time,e,t,400),s]);return[...new Map(n.reverse()).values()].reverse()}var em=100;function al(i,e,t){let n=new Array(em).fill(0);for(let{time:r,kind:o}of i)o==="tick"&&++n[im(r,e,t,em)];let s=Math.max(...n);return s>0?n.map(r=>r/s):[]}function im(i,e,t,n){return Math.min(Math.max(Math.floor(n*(i-e)/(t-e||1)),0),n-1)}var ny="alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma tau upsilon phi chi psi omega",iy="\u03B1\u03B2\u03B3\u03B4\u03B5\u03B6\u03B7\u03B8\u03B9\u03BA\u03BB\u03BC\u03BD\u03BE\u03BF\u03C0\u03C1\u03C3\u03C4\u03C5\u03C6\u03C7\u03C8\u03C9";function sm(i){let e=ny.split(" ");return i.replace(/[a-z]+/g,t=>e.includes(t)?iy[e.indexOf(t)]:t)}var Ho=["#2563eb","#dc2626","#16a34a","#d97706","#7c3aed","#0891b2","#db2777","#65a30d"],ll=600;function Vo(i){let e=getComputedStyle(document.documentElement),t=e.getPropertyValue("--ink-soft").trim(),n={stroke:e.getPropertyValue("--line").trim(),width:1};return{label:i,stroke:t,grid:n,ticks:n,labelSize:18,font:"11px system-ui",labelFont:"11px system-ui",values:(s,r,o,a,l)=>nm(r,l)}}function cl(i){let e=(t,n)=>Math.max(64,36+6.5*Math.max(0,...(n??[]).map(s=>s.length)));return{...Vo(i),size:e}}function hl(i,e){let t=Math.max(Math.abs(i),Math.abs(e)),n=Math.max(.06*(e-i),e-i<1e-6*t?.001*t:0,1e-12);return[i-n,e+n]}function et(i,e={},...t){let n=Object.assign(document.createElement(i),e);return n.append(...t),n}function Vt(i){let e=document.getElementById(i);if(e===null)throw new Error(`the page has no #${i}`);return e}var sy=20,ul=class{constructor(e,t,n){this.head=e;this.motion=t;let s=e.columns.slice(0,e.scene.first),r=s.filter(l=>l.kind==="coordinate").length,o=r>0?1:Math.min(1,s.length-1),a=r>0?1+r:s.length-1;this.choices=[this.choice("to the right",s,o),this.choice("upward",s,a)],!(s.length<2)&&(n.append(et("p",{className:"portrait"},this.choices[1]," over ",this.choices[0]),this.board),this.rebuild())}head;motion;plot=null;board=et("div");dot=et("i",{className:"dot"});choices;choice(e,t,n){let s=et("select",{ariaLabel:`Column of the portrait, ${e}`});return t.forEach(({name:r},o)=>s.append(new Option(r,`${o}`,o===n,o===n))),s.onchange=()=>this.rebuild(),s}values(e){let t=Number(this.choices[e].value),{scale:n,shift:s}=this.head.columns[t].display;return this.motion.column(t).map(r=>r*n+s)}get data(){return[null,[this.values(0),this.values(1)]]}rebuild(){this.plot?.destroy();let[e,t]=this.choices.map(s=>{let{name:r,display:o}=this.head.columns[Number(s.value)],a=`[${o.unit||"1"}]`;return r.length<=sy?`${r} ${a}`:a}),n=s=>()=>{let[r,o]=[1/0,-1/0];for(let a of this.values(s))Number.isFinite(a)&&([r,o]=[Math.min(r,a),Math.max(o,a)]);return o>r||([r,o]=[(Number.isFinite(r)?r:0)-1,(Number.isFinite(o)?o:0)+1]),hl(r,o)};this.plot=new _n({...this.size(),mode:2,scales:{x:{time:!1,range:n(0)},y:{range:n(1)}},axes:[{...Vo(e),size:40},cl(t)],cursor:{show:!1},legend:{show:!1},series:[{},{facets:[{scale:"x",auto:!0},{scale:"y",auto:!0}],paths:ry}]},this.data,this.board),this.plot.over.append(this.dot)}show(e){this.motion=e,this.plot?.setData(this.data)}point(e){if(this.plot===null||this.motion.count===0||this.board.clientWidth===0)return;let t=this.motion.rowAt(e),[n,s]=this.choices.map(r=>{let o=Number(r.value),{scale:a,shift:l}=this.head.columns[o].display;return this.motion.at(t,o)*a+l});this.dot.style.left=`${this.plot.valToPos(n,"x")}px`,this.dot.style.top=`${this.plot.valToPos(s,"y")}px`}size(){return{width:Math.max(this.board.clientWidth||ll,240),height:240}}resize(){this.plot?.setSize(this.size())}};function ry(i){let[e,t]=i.data[1],{ctx:n}=i;return n.save(),n.beginPath(),n.rect(i.bbox.left,i.bbox.top,i.bbox.width,i.bbox.height),n.clip(),n.beginPath(),e.forEach((s,r)=>n.lineTo(i.valToPos(s,"x",!0),i.valToPos(t[r],"y",!0))),n.strokeStyle=Ho[0],n.lineWidth=1.5*window.devicePixelRatio,n.stroke(),n.restore(),null}var rm=4,dl=class{constructor(e,t,n,s){this.head=e;this.sought=s;this.motion=t,this.events=e.events;let r=this.columns(),o=r.filter(({column:c})=>e.curves.includes(c.name)),a=o.length>0?o:r.filter(({column:c})=>c.kind==="coordinate").slice(0,rm);this.chosen=new Set((a.length>0?a:r.slice(0,rm)).map(({index:c})=>c));let l=r.map(({column:c,index:h})=>this.choice(c,h));this.board=et("div"),n.append(et("details",{},et("summary",{textContent:"Choose curves"}),...l),this.board),this.portrait=new ul(e,t,n),new ResizeObserver(([{contentRect:c}])=>{this.seen=c.width>0,this.resize()}).observe(n),window.addEventListener("beforeprint",()=>{this.seen=!0,this.point(this.time)}),this.rebuild()}head;sought;charts=[];chosen;board;portrait;motion;events;family=[];time=0;seen=!1;columns(){return this.head.columns.map((e,t)=>({column:e,index:t})).slice(1,this.head.scene.first)}choice(e,t){let n=et("input",{type:"checkbox",checked:this.chosen.has(t)});n.onchange=()=>{n.checked?this.chosen.add(t):this.chosen.delete(t),this.rebuild()};let s=e.display.unit?` [${e.display.unit}]`:"";return et("label",{className:"choice",title:e.doc??""},n,`${e.name}${s}`)}rebuild(){for(let s of this.charts)s.plot.destroy();this.charts.length=0;let e=new Map;for(let s of[...this.chosen].sort((r,o)=>r-o)){let r=this.head.columns[s].display.unit;e.set(r,[...e.get(r)??[],s])}for(let[s,r]of e)this.overTime(s,r);let t=this.head.scene.first+this.head.scene.count,n={name:"energy",display:{unit:"J",scale:1,shift:0}};this.add("J",[n.name],s=>[s.column(0),s.column(t)]),this.point(this.time)}value(e,t){let{scale:n,shift:s}=this.head.columns[t].display;return e.column(t).map(r=>r*n+s)}overTime(e,t){let n=t.map(r=>this.head.columns[r].name),s=r=>t.map(o=>this.value(r,o));this.add(e,n,r=>[r.column(0),...s(r)])}underlay(e,t){let{ctx:n,bbox:s}=e;n.save(),n.beginPath(),n.rect(s.left,s.top,s.width,s.height),n.clip(),n.lineWidth=window.devicePixelRatio,n.strokeStyle="rgb(148 163 184 / 45%)";for(let c of this.family){let[h,...u]=t(c);for(let d of u)n.beginPath(),h.forEach((f,g)=>n.lineTo(e.valToPos(f,"x",!0),e.valToPos(d[g],"y",!0))),n.stroke()}let{min:r=0,max:o=1}=e.scales.x,a=7*window.devicePixelRatio,l=al(this.events,r,o);n.fillStyle="#64748b",l.forEach((c,h)=>{n.globalAlpha=.5*c,n.fillRect(s.left+s.width*h/l.length,s.top+s.height-a,s.width/l.length,a)}),n.globalAlpha=1,n.strokeStyle="#dc2626";for(let{time:c}of ol(this.events,r,o)){let h=e.valToPos(c,"x",!0);n.beginPath(),n.moveTo(h,s.top+s.height),n.lineTo(h,s.top+s.height-a),n.stroke()}n.restore()}range(e,t,n){let[s,r]=[t??0,n??1];for(let o of this.family)for(let a of e(o).slice(1))for(let l of a)Number.isFinite(l)&&([s,r]=[Math.min(s,l),Math.max(r,l)]);return hl(s,r)}add(e,t,n){let s=new _n({...this.size(),scales:{x:{time:!1},y:{range:(r,o,a)=>this.range(n,o,a)}},axes:[{...Vo("t [s]"),size:40},cl(e===""?"":`[${e}]`)],cursor:{sync:{key:"time"},drag:{x:!1,y:!1}},series:[{label:"t",value:(r,o)=>om(o,"s")},...t.map((r,o)=>({label:r,stroke:Ho[o%Ho.length],width:1.5,value:(a,l)=>om(l,e)}))],hooks:{ready:[r=>r.over.addEventListener("click",()=>this.seek(r))],drawAxes:[r=>this.underlay(r,n)]}},n(this.motion),this.board);this.charts.push({plot:s,data:n})}seek(e){e.cursor.left!==void 0&&e.cursor.left>=0&&this.sought(e.posToVal(e.cursor.left,"x"))}show(e,t){this.motion=e,this.events=t;for(let{plot:n,data:s}of this.charts)n.setData(s(e));this.portrait.show(e)}behind(e){this.family=e,this.rebuild()}point(e){if(this.time=e,!!this.seen){for(let{plot:t}of this.charts)t.setCursor({left:t.valToPos(e,"x"),top:-10},!1);this.portrait.point(e)}}size(){return{width:Math.max(this.board.clientWidth||ll,240),height:190}}resize(){for(let{plot:e}of this.charts)e.setSize(this.size());this.portrait.resize(),queueMicrotask(()=>this.point(this.time))}};function om(i,e){return i===null||!Number.isFinite(i)?"\u2013":`${Hi(i,5)} ${e}`}function Br(i,e){let t=document.createElement("a");t.href=URL.createObjectURL(i),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e3)}function am(i,e){i.toBlob(t=>t!==null&&Br(t,`${e.name}.png`),"image/png")}function lm(i,e){let t=e.columns.slice(0,e.scene.first),n=r=>/[",\n]/.test(r)?`"${r.replaceAll('"','""')}"`:r,s=[t.map(r=>n(r.name)).join(",")];for(let r=0;r<i.count;++r)s.push(t.map((o,a)=>i.at(r,a)).join(","));Br(new Blob([`${s.join(`
`)}
`],{type:"text/csv"}),`${e.name}.csv`)}function cm(i,e){let t=[],n=new MediaRecorder(i.captureStream(60),{mimeType:"video/webm"});return n.ondataavailable=s=>t.push(s.data),n.onstop=()=>Br(new Blob(t,{type:"video/webm"}),`${e.name}.webm`),n.start(),()=>n.stop()}var Su=class{list=[];put(...e){for(let t of e)this.list.push(t)}word(e){this.put(e&255,e>>8)}text(e){for(let t of e)this.put(t.charCodeAt(0))}get all(){return Uint8Array.from(this.list)}},oy=5;function hm(i,e){return i[e]>>3<<10|i[e+1]>>3<<5|i[e+2]>>3}function ay(i){let e=new Uint32Array(1<<3*oy);for(let{data:o}of i)for(let a=0;a<o.length;a+=4)++e[hm(o,a)];let t=o=>[10,5,0].map(a=>Math.round((o>>a&31)*255/31)),n=[...e.keys()].filter(o=>e[o]>0).sort((o,a)=>e[a]-e[o]),s=n.slice(0,256).map(t),r=new Uint8Array(e.length);for(let o of n){let a=t(o),l=s.map(c=>c.reduce((h,u,d)=>h+(u-a[d])**2,0));r[o]=l.indexOf(Math.min(...l))}return{colors:s,places:r}}function ly(i,e){let[t,n]=[256,257],s=new Map,[r,o,a,l]=[258,9,0,0],c=[],h=()=>{c.length>0&&e.put(c.length,...c),c=[]},u=f=>{for(a|=f<<l,l+=o;l>=8;)c.push(a&255),a>>=8,l-=8,c.length===255&&h()};e.put(8),u(t);let d=i[0];for(let f=1;f<i.length;++f){let g=d<<8|i[f],b=s.get(g);if(b!==void 0){d=b;continue}u(d),r<4096?(r===1<<o&&o<12&&++o,s.set(g,r++)):(u(t),s=new Map,[r,o]=[258,9]),d=i[f]}u(d),r===1<<o&&o<12&&++o,u(n),l>0&&c.push(a&255),h(),e.put(0)}function um(i,e){let t=new Su,{width:n,height:s}=i[0];t.text("GIF89a"),t.word(n),t.word(s),t.put(247,0,0);let{colors:r,places:o}=ay(i);for(let a=0;a<256;++a)t.put(...r[a]??[0,0,0]);t.put(33,255,11),t.text("NETSCAPE2.0"),t.put(3,1,0,0,0);for(let{data:a}of i){t.put(33,249,4,0),t.word(Math.round(e/10)),t.put(0,0,44,0,0,0,0),t.word(n),t.word(s),t.put(0);let l=new Uint8Array(n*s);for(let c=0;c<l.length;++c)l[c]=o[hm(a,4*c)];ly(l,t)}return t.put(59),new Blob([t.all],{type:"image/gif"})}function cy(i,e){return i.columns.flatMap(({name:t,kind:n,unit:s},r)=>{let o=i.parameters.findIndex(a=>n==="coordinate"&&a.name===`${t}.start`);return o<0?[]:[{parameter:o,column:r,size:s==="m"?e:1}]})}function dm(i,e,t,n){let s=null,[r,o]=[0,0],a=null,l=cy(i,e.length);t.addEventListener("pointerdown",c=>{s=n.ready()&&c.button===0&&l.length>0&&c.target===e.canvas?e.held(c.clientX,c.clientY):null,s!==null&&(c.stopPropagation(),[r,o,a]=[c.clientX,c.clientY,null],e.canvas.setPointerCapture(c.pointerId))},{capture:!0}),t.addEventListener("pointermove",c=>{if(s===null)return;if(a===null){if(Math.hypot(c.clientX-r,c.clientY-o)<3)return;n.begin(),a=e.facingPlace(r,o,s.point).place.sub(s.point)}let{place:h,across:u}=e.facingPlace(c.clientX,c.clientY,s.point);if(s.shape.kind!=="dial"){n.pull({parts:s.parts,goal:h.sub(a).toArray(),across:u.map(p=>p.toArray()),starts:l});return}let[d,f]=u.map(p=>h.clone().sub(s?.point??h).dot(p)),g=Math.atan2(-d,f),b=2*Math.PI;n.turn(`${s.shape.name}.start`,p=>g+b*Math.round((p-g)/b))});for(let c of["pointerup","pointercancel"])t.addEventListener(c,()=>s=null)}var hy="0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;,=>?@^_`{|}~";function wu(i){let e=new Uint8Array(128);for(let s=0;s<85;++s)e[hy.charCodeAt(s)]=s;let t=i.trim(),n=new DataView(new ArrayBuffer(4*Math.ceil(t.length/5)));for(let s=0;s<t.length;s+=5){let r=0;for(let o=0;o<5;++o)r=r*85+(s+o<t.length?e[t.charCodeAt(s+o)]:84);n.setUint32(4*s/5,r)}return new Uint8Array(n.buffer,0,Math.floor(4*t.length/5))}async function fl(i){let e=new Blob([wu(i)]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(e).arrayBuffer())}function Tu(i){return document.getElementById(i)?.textContent??""}function fm(){return JSON.parse(Tu("head"))}function zr(i){return fl(Tu(i))}async function pm(){document.fonts.add(await new FontFace("lagdsl Math",wu(Tu("font"))).load())}function pl(i,e,t){return(i.words[e]??`The run ended with status ${e}.`).replace(/\{(\w+)\}/g,(s,r)=>[...new Set(t.map(o=>i.blamed[r][o]))].join(", "))}var kr=class{constructor(e,t){this.width=e;this.values=t;this.count=Math.floor(t.length/e)}width;values;count;at(e,t){return this.values[e*this.width+t]}get last(){return this.count>0?this.at(this.count-1,0):0}rowAt(e){let t=0,n=this.count-1;for(;t<n;){let s=t+n+1>>1;this.at(s,0)<=e?t=s:n=s-1}return t}state(e,t){let n=this.rowAt(e),s=Math.min(n+1,this.count-1),r=this.at(s,0)-this.at(n,0),o=r>0?Math.min(Math.max((e-this.at(n,0))/r,0),1):0;for(let a=0;a<this.width;++a){let l=this.at(n,a);t[a]=l+o*(this.at(s,a)-l)}return t}largest(e){let t=0;for(let n=0;n<this.count;++n){let s=Math.abs(this.at(n,e));Number.isFinite(s)&&(t=Math.max(t,s))}return t}column(e){return Float64Array.from({length:this.count},(t,n)=>this.at(n,e))}};function mm(i,e){let t=new Float32Array(e.buffer),n=i.runs?.map(o=>o.rows)??[i.rows],s=t.length/n.reduce((o,a)=>o+a,0),r=0;return n.map(o=>{let a=new Float32Array(o*s);for(let l=0;l<s;++l)for(let c=0;c<o;++c)a[c*s+l]=t[r+l*o+c];return r+=o*s,new kr(s,a)})}function Au(i){if(i.length===1)return i[0];let e=new Float32Array(i.reduce((n,s)=>n+s.values.length,0)),t=0;for(let n of i)e.set(n.values,t),t+=n.values.length;return new kr(i[0].width,e)}var tr=class i{constructor(e,t,n){this.worker=e;this.width=t;this.told=n;e.onmessage=s=>this.arrived(s.data)}worker;width;told;busy=!1;waiting=null;number=0;static async begin(e,t,n,{tape:s="tape",by:r=[]}={}){if(e.live===!1||typeof WebAssembly>"u"||typeof Worker>"u")return null;try{let o=new Blob([await zr("worker")],{type:"text/javascript"}),a=new Worker(URL.createObjectURL(o)),l={wasm:(await zr("wasm")).buffer,tape:(await zr(s)).buffer,start:e.start,stop:e.stop,rows:t,tolerance:e.tolerance,lasting:e.lasting,by:r,entries:e.blamed.entries.length},c=await new Promise((h,u)=>{a.onmessage=d=>h(d.data.ready),a.onerror=d=>u(new Error(d.message)),a.postMessage(l,[l.wasm,l.tape])});return new i(a,c,n)}catch{return null}}run(e,t,n=null){this.waiting={parameters:e,inputs:t,pull:n},this.busy||this.next()}next(){this.waiting!==null&&(this.worker.postMessage({number:++this.number,...this.waiting}),this.waiting=null,this.busy=!0)}arrived(e){this.busy=!1,this.told({...e,motion:new kr(this.width,e.rows)}),this.next()}};function gm(i,e){let t=[0,0,0];for(let[n,s,r]of e)for(let o=0;o<3;++o){let[a,l]=[(o+1)%3,(o+2)%3],c=r===void 0?i[n+o]:i[n+a]*i[r+l]-i[n+l]*i[r+a];t[o]+=s*c}return t}var _m=9,ml=-1;var uy=300,dy=12,fy=1e-9,py=["coordinate","rate","state","output"],my="The motion takes long: nothing is told of its end.",gy="The motion ends before its time: its end moves, too.";function _y(i,e){let{angle:t,group:n,display:s}=i,r=t&&n==="start";return e!==0&&!r?{si:.01*Math.abs(e),words:"1 %",ranked:!0}:{si:1/s.scale,words:`1 ${s.unit}`.trim(),ranked:r}}var gl=class{constructor(e,t){this.head=e;if(this.quantities=[...e.parameters,...e.inputs].filter((o,a)=>{let l=o.kind==="Real";return l&&this.by.push(a),l}),this.by.length===0||e.live===!1||e.modes!==void 0)return;let n=document.createElement("summary");n.textContent="What moves the end most",this.chooser.ariaLabel="The curve whose end moves",e.columns.slice(0,e.scene.first).forEach((o,a)=>{py.includes(o.kind)&&this.chooser.append(new Option(o.name,`${a}`))}),this.chooser.onchange=()=>this.show();let s=document.createElement("table");s.className="influence",s.append(this.rows),this.board.className="influences",this.board.open=!0,this.board.ontoggle=()=>this.ask();let r=document.createElement("div");r.append(this.chooser,this.told),this.board.append(n,r,s),t.append(this.board),e.differentiable||this.say("Delayed values have no derivatives yet.",!0)}head;by=[];quantities;board=document.createElement("details");chooser=document.createElement("select");told=document.createElement("p");rows=document.createElement("tbody");live=null;values=[];wish=null;timer=0;outcome=null;rest(e,t){!this.board.isConnected||!this.head.differentiable||(this.wish={parameters:e,inputs:t},this.board.ariaBusy="true",clearTimeout(this.timer),this.timer=setTimeout(()=>this.ask(),uy))}ask(){if(this.wish===null||!this.board.open)return;let{parameters:e,inputs:t}=this.wish;this.wish=null;let n=[...e,...t];this.values=this.by.map(s=>n[s]),this.live??=tr.begin(this.head,2,s=>this.arrived(s),{by:this.by}),this.live.then(s=>s?.run(e,t))}arrived(e){this.wish===null&&(this.board.ariaBusy="false",this.outcome=e,this.show(),document.documentElement.dataset.influence=e.took.toFixed(2))}say(e,t=!1){this.told.textContent=e,this.chooser.hidden=t}show(){if(this.outcome===null)return;let{status:e,derivatives:t,motion:n,time:s,blamed:r}=this.outcome;if(this.rows.replaceChildren(),t.length===0){let v=e===0||e===_m?gy:pl(this.head,e,r);this.say(`${e===ml?my:v} (t = ${s.toPrecision(5)} s)`,!0);return}let o=Number(this.chooser.value),a=this.head.columns[o],{scale:l,shift:c,unit:h}=a.display,d=`is ${`${Hi(n.at(n.count-1,o)*l+c,4)} ${h}`.trim()} at ${Hi(s,4)} s`;this.say(`${d} and changes with`);let f=this.quantities.map((v,C)=>{let{si:M,words:R,ranked:E}=_y(v,this.values[C]);return{name:v.name,words:R,ranked:E,change:t[C*n.width+o]*M*l}}),g=({change:v})=>Math.abs(v),b=fy*Math.max(...f.map(g)),p=f.filter(v=>g(v)>b).sort((v,C)=>g(C)-g(v)),m=p.filter(v=>v.ranked);p.length===0&&this.say(`${d}; no slider moves it.`);for(let v of[...m,...p.filter(C=>!C.ranked)].slice(0,dy))this.row(v,v.ranked?g(v)/g(m[0]):0,h)}row({name:e,words:t,change:n},s,r){let o=document.createElement("tr"),a=document.createElement("th");a.scope="row",a.textContent=e.replace(/\.start$/," at the start");let l=document.createElement("td");l.textContent=t;let c=document.createElement("td");c.className="bar";let h=document.createElement("i");h.style.width=`${100*s}%`,h.className=n<0?"less":"more",s>0&&c.append(h);let u=document.createElement("td");u.textContent=`${n>0?"+":"\u2212"}${Hi(Math.abs(n),3)} ${r}`.trim(),o.append(a,l,c,u),this.rows.append(o)}};var xy=[[/^(Arrow|Home|End)/,"input:not([type=checkbox]):not([aria-label=Time]), select, [role=tab]"],[/^[+-]$/,"input[type=number]"]];function xm(i){let e=t=>{if(t.ctrlKey||t.metaKey||t.altKey||!(t.target instanceof Element))return;let{key:n,target:s}=t;return xy.some(([r,o])=>r.test(n)&&s.matches(o))?void 0:i[n]};document.addEventListener("keydown",t=>{let n=e(t);n!==void 0&&(t.preventDefault(),n())}),document.addEventListener("keyup",t=>t.key===" "&&e(t)!==void 0&&t.preventDefault())}var Gs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Hs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Qm=0,id=1,eg=2;var Ma=1,tg=2,bo=3,Vs=0,$n=1,Zn=2,hr=0,Mo=1,sd=2,rd=3,od=4,ng=5;var ur=100,ig=101,sg=102,rg=103,og=104,ag=200,lg=201,cg=202,hg=203,ad=204,ld=205,ug=206,dg=207,fg=208,pg=209,mg=210,gg=211,_g=212,xg=213,yg=214,Wl=0,Xl=1,Yl=2,ro=3,ql=4,$l=5,Zl=6,Jl=7,Mc=0,vg=1,bg=2,Zi=0,cd=1,hd=2,ud=3,dd=4,fd=5,pd=6,md=7;var gd=300,dr=301,So=302,Sc=303,wc=304,Kl=1e3,Wi=1001,jl=1002,Cn=1003,Mg=1004;var Sa=1005;var Yn=1006,Tc=1007;var _s=1008;var Kn=1009,_d=1010,xd=1011,wo=1012,Ac=1013,Pi=1014,Ii=1015,Li=1016,Ec=1017,Cc=1018,fr=1020,yd=35902,vd=35899,bd=1021,Md=1022,Di=1023,ds=1026,xs=1027,Sd=1028,Rc=1029,Ws=1030,Pc=1031;var Ic=1033,wa=33776,Ta=33777,Aa=33778,Ea=33779,Lc=35840,Dc=35841,Nc=35842,Uc=35843,Oc=36196,Fc=37492,Bc=37496,zc=37488,kc=37489,Ca=37490,Gc=37491,Hc=37808,Vc=37809,Wc=37810,Xc=37811,Yc=37812,qc=37813,$c=37814,Zc=37815,Jc=37816,Kc=37817,jc=37818,Qc=37819,eh=37820,th=37821,nh=36492,ih=36494,sh=36495,rh=36283,oh=36284,Ra=36285,ah=36286;var ta=2300,Ql=2301,Hl=2302,Zu=2303,Ju=2400,Ku=2401,ju=2402;var Sg=3200;var lh=0,wg=1,ys="",Vn="srgb",na="srgb-linear",ia="linear",Nt="srgb";var Vl=7680;var Tg=519,Ag=512,Eg=513,Cg=514,wd=515,Rg=516,Pg=517,Td=518,Ad=519,Ed=35044;var Cd="300 es",gi=2e3,oo=2001;function yy(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function vy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function sa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Ig(){let i=sa("canvas");return i.style.display="block",i}var ym={},ao=null;function ra(...i){let e="THREE."+i.shift();ao?ao("log",e,...i):console.log(e,...i)}function Lg(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function rt(...i){i=Lg(i);let e="THREE."+i.shift();if(ao)ao("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function ht(...i){i=Lg(i);let e="THREE."+i.shift();if(ao)ao("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function jo(...i){let e=i.join(" ");e in ym||(ym[e]=!0,rt(...i))}function Dg(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Ng={[Wl]:Wl,[Yl]:Zl,[ql]:ql,[ro]:$l,[Xl]:Xl,[Zl]:Yl,[Jl]:Jl,[$l]:ro},Ei=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Dn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],vm=1234567,Qo=Math.PI/180,lo=180/Math.PI;function Xs(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Dn[i&255]+Dn[i>>8&255]+Dn[i>>16&255]+Dn[i>>24&255]+"-"+Dn[e&255]+Dn[e>>8&255]+"-"+Dn[e>>16&15|64]+Dn[e>>24&255]+"-"+Dn[t&63|128]+Dn[t>>8&255]+"-"+Dn[t>>16&255]+Dn[t>>24&255]+Dn[n&255]+Dn[n>>8&255]+Dn[n>>16&255]+Dn[n>>24&255]).toLowerCase()}function vt(i,e,t){return Math.max(e,Math.min(t,i))}function Rd(i,e){return(i%e+e)%e}function by(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function My(i,e,t){return i!==e?(t-i)/(e-i):0}function ea(i,e,t){return(1-t)*i+t*e}function Sy(i,e,t,n){return ea(i,e,1-Math.exp(-t*n))}function wy(i,e=1){return e-Math.abs(Rd(i,e*2)-e)}function Ty(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Ay(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Ey(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Cy(i,e){return i+Math.random()*(e-i)}function Ry(i){return i*(.5-Math.random())}function Py(i){i!==void 0&&(vm=i);let e=vm+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Iy(i){return i*Qo}function Ly(i){return i*lo}function Dy(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Ny(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Pd(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Uy(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*h,a*c);break;default:rt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ch(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Id(i,e){if(e.constructor===Float32Array)return i;let t=ch(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Ld(i,e){if(e.constructor===Float32Array)return i;let t=ch(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var hh={DEG2RAD:Qo,RAD2DEG:lo,generateUUID:Xs,clamp:vt,euclideanModulo:Rd,mapLinear:by,inverseLerp:My,lerp:ea,damp:Sy,pingpong:wy,smoothstep:Ty,smootherstep:Ay,randInt:Ey,randFloat:Cy,randFloatSpread:Ry,seededRandom:Py,degToRad:Iy,radToDeg:Ly,isPowerOfTwo:Dy,ceilPowerOfTwo:Ny,floorPowerOfTwo:Pd,setQuaternionFromProperEuler:Uy,normalize:Ld,denormalize:Id},qe=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=vt(this.x,e.x,t.x),this.y=vt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=vt(this.x,e,t),this.y=vt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(vt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(vt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},li=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],b=r[o+3];if(u!==b||l!==d||c!==f||h!==g){let p=l*d+c*f+h*g+u*b;p<0&&(d=-d,f=-f,g=-g,b=-b,p=-p);let m=1-a;if(p<.9995){let v=Math.acos(p),C=Math.sin(v);m=Math.sin(m*v)/C,a=Math.sin(a*v)/C,l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+b*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+g*a,u=u*m+b*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*f-c*d,e[t+1]=l*g+h*d+c*u-a*f,e[t+2]=c*g+h*f+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"YZX":this._x=d*h*u+c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u-d*f*g;break;case"XZY":this._x=d*h*u-c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u+d*f*g;break;default:rt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(vt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(bm.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(bm.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=vt(this.x,e.x,t.x),this.y=vt(this.y,e.y,t.y),this.z=vt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=vt(this.x,e,t),this.y=vt(this.y,e,t),this.z=vt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(vt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Eu.copy(this).projectOnVector(e),this.sub(Eu)}reflect(e){return this.sub(Eu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(vt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Eu=new F,bm=new li,at=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],g=n[8],b=s[0],p=s[3],m=s[6],v=s[1],C=s[4],M=s[7],R=s[2],E=s[5],y=s[8];return r[0]=o*b+a*v+l*R,r[3]=o*p+a*C+l*E,r[6]=o*m+a*M+l*y,r[1]=c*b+h*v+u*R,r[4]=c*p+h*C+u*E,r[7]=c*m+h*M+u*y,r[2]=d*b+f*v+g*R,r[5]=d*p+f*C+g*E,r[8]=d*m+f*M+g*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,g=t*u+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/g;return e[0]=u*b,e[1]=(s*c-h*n)*b,e[2]=(a*n-s*o)*b,e[3]=d*b,e[4]=(h*t-s*l)*b,e[5]=(s*r-a*t)*b,e[6]=f*b,e[7]=(n*l-c*t)*b,e[8]=(o*t-n*r)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return jo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Cu.makeScale(e,t)),this}rotate(e){return jo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Cu.makeRotation(-e)),this}translate(e,t){return jo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Cu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Cu=new at,Mm=new at().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Sm=new at().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Oy(){let i={enabled:!0,workingColorSpace:na,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Nt&&(s.r=us(s.r),s.g=us(s.g),s.b=us(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Nt&&(s.r=so(s.r),s.g=so(s.g),s.b=so(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?ia:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[na]:{primaries:e,whitePoint:n,transfer:ia,toXYZ:Mm,fromXYZ:Sm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Vn},outputColorSpaceConfig:{drawingBufferColorSpace:Vn}},[Vn]:{primaries:e,whitePoint:n,transfer:Nt,toXYZ:Mm,fromXYZ:Sm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Vn}}}),i}var Tt=Oy();function us(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function so(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Gr,ec=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Gr===void 0&&(Gr=sa("canvas")),Gr.width=e.width,Gr.height=e.height;let s=Gr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Gr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=sa("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=us(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(us(t[n]/255)*255):t[n]=us(t[n]);return{data:t,width:e.width,height:e.height}}else return rt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Fy=0,co=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Fy++}),this.uuid=Xs(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ru(s[o].image)):r.push(Ru(s[o]))}else r=Ru(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Ru(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ec.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(rt("Texture: Unable to serialize Texture."),{})}var By=0,Pu=new F,qn=class i extends Ei{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Wi,s=Wi,r=Yn,o=_s,a=Di,l=Kn,c=i.DEFAULT_ANISOTROPY,h=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:By++}),this.uuid=Xs(),this.name="",this.source=new co(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new qe(0,0),this.repeat=new qe(1,1),this.center=new qe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new at,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Pu).x}get height(){return this.source.getSize(Pu).y}get depth(){return this.source.getSize(Pu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){rt(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){rt(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==gd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Kl:e.x=e.x-Math.floor(e.x);break;case Wi:e.x=e.x<0?0:1;break;case jl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Kl:e.y=e.y-Math.floor(e.y);break;case Wi:e.y=e.y<0?0:1;break;case jl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};qn.DEFAULT_IMAGE=null;qn.DEFAULT_MAPPING=gd;qn.DEFAULT_ANISOTROPY=1;var Ct=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],g=l[9],b=l[2],p=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-b)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+b)<.1&&Math.abs(g+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,M=(f+1)/2,R=(m+1)/2,E=(h+d)/4,y=(u+b)/4,A=(g+p)/4;return C>M&&C>R?C<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(C),s=E/n,r=y/n):M>R?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=E/s,r=A/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=y/r,s=A/r),this.set(n,s,r,t),this}let v=Math.sqrt((p-g)*(p-g)+(u-b)*(u-b)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(p-g)/v,this.y=(u-b)/v,this.z=(d-h)/v,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=vt(this.x,e.x,t.x),this.y=vt(this.y,e.y,t.y),this.z=vt(this.z,e.z,t.z),this.w=vt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=vt(this.x,e,t),this.y=vt(this.y,e,t),this.z=vt(this.z,e,t),this.w=vt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(vt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},tc=class extends Ei{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Yn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Ct(0,0,e,t),this.scissorTest=!1,this.viewport=new Ct(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new qn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Yn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new co(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ci=class extends tc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},oa=class extends qn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var nc=class extends qn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=Wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var bt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,g,b,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,b,p)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,b,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=g,m[11]=b,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Hr.setFromMatrixColumn(e,0).length(),r=1/Hr.setFromMatrixColumn(e,1).length(),o=1/Hr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,g=a*h,b=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+g*c,t[5]=d-b*c,t[9]=-a*l,t[2]=b-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,g=c*h,b=c*u;t[0]=d+b*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=b+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,g=c*h,b=c*u;t[0]=d-b*a,t[4]=-o*u,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=b-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,g=a*h,b=a*u;t[0]=l*h,t[4]=g*c-f,t[8]=d*c+b,t[1]=l*u,t[5]=b*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,b=a*c;t[0]=l*h,t[4]=b-d*u,t[8]=g*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+g,t[10]=d-b*u}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,b=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+b,t[5]=o*h,t[9]=f*u-g,t[2]=g*u-f,t[6]=a*h,t[10]=b*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(zy,e,ky)}lookAt(e,t,n){let s=this.elements;return oi.subVectors(e,t),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),Is.crossVectors(n,oi),Is.lengthSq()===0&&(Math.abs(n.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),Is.crossVectors(n,oi)),Is.normalize(),_l.crossVectors(oi,Is),s[0]=Is.x,s[4]=_l.x,s[8]=oi.x,s[1]=Is.y,s[5]=_l.y,s[9]=oi.y,s[2]=Is.z,s[6]=_l.z,s[10]=oi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],g=n[2],b=n[6],p=n[10],m=n[14],v=n[3],C=n[7],M=n[11],R=n[15],E=s[0],y=s[4],A=s[8],k=s[12],U=s[1],L=s[5],G=s[9],X=s[13],D=s[2],V=s[6],Y=s[10],H=s[14],ce=s[3],q=s[7],j=s[11],ie=s[15];return r[0]=o*E+a*U+l*D+c*ce,r[4]=o*y+a*L+l*V+c*q,r[8]=o*A+a*G+l*Y+c*j,r[12]=o*k+a*X+l*H+c*ie,r[1]=h*E+u*U+d*D+f*ce,r[5]=h*y+u*L+d*V+f*q,r[9]=h*A+u*G+d*Y+f*j,r[13]=h*k+u*X+d*H+f*ie,r[2]=g*E+b*U+p*D+m*ce,r[6]=g*y+b*L+p*V+m*q,r[10]=g*A+b*G+p*Y+m*j,r[14]=g*k+b*X+p*H+m*ie,r[3]=v*E+C*U+M*D+R*ce,r[7]=v*y+C*L+M*V+R*q,r[11]=v*A+C*G+M*Y+R*j,r[15]=v*k+C*X+M*H+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],g=e[3],b=e[7],p=e[11],m=e[15],v=l*f-c*d,C=a*f-c*u,M=a*d-l*u,R=o*f-c*h,E=o*d-l*h,y=o*u-a*h;return t*(b*v-p*C+m*M)-n*(g*v-p*R+m*E)+s*(g*C-b*R+m*y)-r*(g*M-b*E+p*y)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],g=e[12],b=e[13],p=e[14],m=e[15],v=t*a-n*o,C=t*l-s*o,M=t*c-r*o,R=n*l-s*a,E=n*c-r*a,y=s*c-r*l,A=h*b-u*g,k=h*p-d*g,U=h*m-f*g,L=u*p-d*b,G=u*m-f*b,X=d*m-f*p,D=v*X-C*G+M*L+R*U-E*k+y*A;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/D;return e[0]=(a*X-l*G+c*L)*V,e[1]=(s*G-n*X-r*L)*V,e[2]=(b*y-p*E+m*R)*V,e[3]=(d*E-u*y-f*R)*V,e[4]=(l*U-o*X-c*k)*V,e[5]=(t*X-s*U+r*k)*V,e[6]=(p*M-g*y-m*C)*V,e[7]=(h*y-d*M+f*C)*V,e[8]=(o*G-a*U+c*A)*V,e[9]=(n*U-t*G-r*A)*V,e[10]=(g*E-b*M+m*v)*V,e[11]=(u*M-h*E-f*v)*V,e[12]=(a*k-o*L-l*A)*V,e[13]=(t*L-n*k+s*A)*V,e[14]=(b*C-g*R-p*v)*V,e[15]=(h*R-u*C+d*v)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,g=r*u,b=o*h,p=o*u,m=a*u,v=l*c,C=l*h,M=l*u,R=n.x,E=n.y,y=n.z;return s[0]=(1-(b+m))*R,s[1]=(f+M)*R,s[2]=(g-C)*R,s[3]=0,s[4]=(f-M)*E,s[5]=(1-(d+m))*E,s[6]=(p+v)*E,s[7]=0,s[8]=(g+C)*y,s[9]=(p-v)*y,s[10]=(1-(d+b))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=Hr.set(s[0],s[1],s[2]).length(),a=Hr.set(s[4],s[5],s[6]).length(),l=Hr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),wi.copy(this);let c=1/o,h=1/a,u=1/l;return wi.elements[0]*=c,wi.elements[1]*=c,wi.elements[2]*=c,wi.elements[4]*=h,wi.elements[5]*=h,wi.elements[6]*=h,wi.elements[8]*=u,wi.elements[9]*=u,wi.elements[10]*=u,t.setFromRotationMatrix(wi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=gi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,b;if(l)g=r/(o-r),b=o*r/(o-r);else if(a===gi)g=-(o+r)/(o-r),b=-2*o*r/(o-r);else if(a===oo)g=-o/(o-r),b=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=gi,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,b;if(l)g=1/(o-r),b=o/(o-r);else if(a===gi)g=-2/(o-r),b=-(o+r)/(o-r);else if(a===oo)g=-1/(o-r),b=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Hr=new F,wi=new bt,zy=new F(0,0,0),ky=new F(1,1,1),Is=new F,_l=new F,oi=new F,wm=new bt,Tm=new li,fs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(vt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-vt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(vt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-vt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(vt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-vt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:rt("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return wm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(wm,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Tm.setFromEuler(this),this.setFromQuaternion(Tm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};fs.DEFAULT_ORDER="XYZ";var ho=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Gy=0,Am=new F,Vr=new li,rs=new bt,xl=new F,Wo=new F,Hy=new F,Vy=new li,Em=new F(1,0,0),Cm=new F(0,1,0),Rm=new F(0,0,1),Pm={type:"added"},Wy={type:"removed"},Wr={type:"childadded",child:null},Iu={type:"childremoved",child:null},xn=class i extends Ei{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Gy++}),this.uuid=Xs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new F,t=new fs,n=new li,s=new F(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new bt},normalMatrix:{value:new at}}),this.matrix=new bt,this.matrixWorld=new bt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ho,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Vr.setFromAxisAngle(e,t),this.quaternion.multiply(Vr),this}rotateOnWorldAxis(e,t){return Vr.setFromAxisAngle(e,t),this.quaternion.premultiply(Vr),this}rotateX(e){return this.rotateOnAxis(Em,e)}rotateY(e){return this.rotateOnAxis(Cm,e)}rotateZ(e){return this.rotateOnAxis(Rm,e)}translateOnAxis(e,t){return Am.copy(e).applyQuaternion(this.quaternion),this.position.add(Am.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Em,e)}translateY(e){return this.translateOnAxis(Cm,e)}translateZ(e){return this.translateOnAxis(Rm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(rs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?xl.copy(e):xl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Wo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?rs.lookAt(Wo,xl,this.up):rs.lookAt(xl,Wo,this.up),this.quaternion.setFromRotationMatrix(rs),s&&(rs.extractRotation(s.matrixWorld),Vr.setFromRotationMatrix(rs),this.quaternion.premultiply(Vr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ht("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Pm),Wr.child=e,this.dispatchEvent(Wr),Wr.child=null):ht("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Wy),Iu.child=e,this.dispatchEvent(Iu),Iu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),rs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),rs.multiply(e.parent.matrixWorld)),e.applyMatrix4(rs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Pm),Wr.child=e,this.dispatchEvent(Wr),Wr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wo,e,Hy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wo,Vy,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};xn.DEFAULT_UP=new F(0,1,0);xn.DEFAULT_MATRIX_AUTO_UPDATE=!0;xn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Un=class extends xn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Xy={type:"move"},uo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Un,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Un,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Un,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let b of e.hand.values()){let p=t.getJointPose(b,n),m=this._getHandJoint(c,b);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Xy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Un;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Ug={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ls={h:0,s:0,l:0},yl={h:0,s:0,l:0};function Lu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var nt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Vn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Tt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Tt.workingColorSpace){return this.r=e,this.g=t,this.b=n,Tt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Tt.workingColorSpace){if(e=Rd(e,1),t=vt(t,0,1),n=vt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Lu(o,r,e+1/3),this.g=Lu(o,r,e),this.b=Lu(o,r,e-1/3)}return Tt.colorSpaceToWorking(this,s),this}setStyle(e,t=Vn){function n(r){r!==void 0&&parseFloat(r)<1&&rt("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:rt("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);rt("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Vn){let n=Ug[e.toLowerCase()];return n!==void 0?this.setHex(n,t):rt("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=us(e.r),this.g=us(e.g),this.b=us(e.b),this}copyLinearToSRGB(e){return this.r=so(e.r),this.g=so(e.g),this.b=so(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Vn){return Tt.workingToColorSpace(Nn.copy(this),e),Math.round(vt(Nn.r*255,0,255))*65536+Math.round(vt(Nn.g*255,0,255))*256+Math.round(vt(Nn.b*255,0,255))}getHexString(e=Vn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Tt.workingColorSpace){Tt.workingToColorSpace(Nn.copy(this),t);let n=Nn.r,s=Nn.g,r=Nn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Tt.workingColorSpace){return Tt.workingToColorSpace(Nn.copy(this),t),e.r=Nn.r,e.g=Nn.g,e.b=Nn.b,e}getStyle(e=Vn){Tt.workingToColorSpace(Nn.copy(this),e);let t=Nn.r,n=Nn.g,s=Nn.b;return e!==Vn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Ls),this.setHSL(Ls.h+e,Ls.s+t,Ls.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Ls),e.getHSL(yl);let n=ea(Ls.h,yl.h,t),s=ea(Ls.s,yl.s,t),r=ea(Ls.l,yl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Nn=new nt;nt.NAMES=Ug;var or=class extends xn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new fs,this.environmentIntensity=1,this.environmentRotation=new fs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ti=new F,os=new F,Du=new F,as=new F,Xr=new F,Yr=new F,Im=new F,Nu=new F,Uu=new F,Ou=new F,Fu=new Ct,Bu=new Ct,zu=new Ct,hs=class i{constructor(e=new F,t=new F,n=new F){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ti.subVectors(e,t),s.cross(Ti);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ti.subVectors(s,t),os.subVectors(n,t),Du.subVectors(e,t);let o=Ti.dot(Ti),a=Ti.dot(os),l=Ti.dot(Du),c=os.dot(os),h=os.dot(Du),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,as)===null?!1:as.x>=0&&as.y>=0&&as.x+as.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,as)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,as.x),l.addScaledVector(o,as.y),l.addScaledVector(a,as.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Fu.setScalar(0),Bu.setScalar(0),zu.setScalar(0),Fu.fromBufferAttribute(e,t),Bu.fromBufferAttribute(e,n),zu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Fu,r.x),o.addScaledVector(Bu,r.y),o.addScaledVector(zu,r.z),o}static isFrontFacing(e,t,n,s){return Ti.subVectors(n,t),os.subVectors(e,t),Ti.cross(os).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ti.subVectors(this.c,this.b),os.subVectors(this.a,this.b),Ti.cross(os).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Xr.subVectors(s,n),Yr.subVectors(r,n),Nu.subVectors(e,n);let l=Xr.dot(Nu),c=Yr.dot(Nu);if(l<=0&&c<=0)return t.copy(n);Uu.subVectors(e,s);let h=Xr.dot(Uu),u=Yr.dot(Uu);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(Xr,o);Ou.subVectors(e,r);let f=Xr.dot(Ou),g=Yr.dot(Ou);if(g>=0&&f<=g)return t.copy(r);let b=f*c-l*g;if(b<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(Yr,a);let p=h*g-f*u;if(p<=0&&u-h>=0&&f-g>=0)return Im.subVectors(r,s),a=(u-h)/(u-h+(f-g)),t.copy(s).addScaledVector(Im,a);let m=1/(p+b+d);return o=b*m,a=d*m,t.copy(n).addScaledVector(Xr,o).addScaledVector(Yr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Jn=class{constructor(e=new F(1/0,1/0,1/0),t=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ai.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ai.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ai.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ai):Ai.fromBufferAttribute(r,o),Ai.applyMatrix4(e.matrixWorld),this.expandByPoint(Ai);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),vl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),vl.copy(n.boundingBox)),vl.applyMatrix4(e.matrixWorld),this.union(vl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ai),Ai.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Xo),bl.subVectors(this.max,Xo),qr.subVectors(e.a,Xo),$r.subVectors(e.b,Xo),Zr.subVectors(e.c,Xo),Ds.subVectors($r,qr),Ns.subVectors(Zr,$r),nr.subVectors(qr,Zr);let t=[0,-Ds.z,Ds.y,0,-Ns.z,Ns.y,0,-nr.z,nr.y,Ds.z,0,-Ds.x,Ns.z,0,-Ns.x,nr.z,0,-nr.x,-Ds.y,Ds.x,0,-Ns.y,Ns.x,0,-nr.y,nr.x,0];return!ku(t,qr,$r,Zr,bl)||(t=[1,0,0,0,1,0,0,0,1],!ku(t,qr,$r,Zr,bl))?!1:(Ml.crossVectors(Ds,Ns),t=[Ml.x,Ml.y,Ml.z],ku(t,qr,$r,Zr,bl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ai).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ai).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ls[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ls[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ls[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ls[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ls[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ls[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ls[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ls[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ls),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ls=[new F,new F,new F,new F,new F,new F,new F,new F],Ai=new F,vl=new Jn,qr=new F,$r=new F,Zr=new F,Ds=new F,Ns=new F,nr=new F,Xo=new F,bl=new F,Ml=new F,ir=new F;function ku(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){ir.fromArray(i,r);let a=s.x*Math.abs(ir.x)+s.y*Math.abs(ir.y)+s.z*Math.abs(ir.z),l=e.dot(ir),c=t.dot(ir),h=n.dot(ir);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var fn=new F,Sl=new qe,Yy=0,En=class extends Ei{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Yy++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Ed,this.updateRanges=[],this.gpuType=Ii,this.version=0,this._normalizationScale=e!==void 0?ch(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Sl.fromBufferAttribute(this,t),Sl.applyMatrix3(e),this.setXY(t,Sl.x,Sl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)fn.fromBufferAttribute(this,t),fn.applyMatrix3(e),this.setXYZ(t,fn.x,fn.y,fn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)fn.fromBufferAttribute(this,t),fn.applyMatrix4(e),this.setXYZ(t,fn.x,fn.y,fn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)fn.fromBufferAttribute(this,t),fn.applyNormalMatrix(e),this.setXYZ(t,fn.x,fn.y,fn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)fn.fromBufferAttribute(this,t),fn.transformDirection(e),this.setXYZ(t,fn.x,fn.y,fn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Id(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Ld(e,this.array)}};var aa=class extends En{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var la=class extends En{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var jt=class extends En{constructor(e,t,n){super(new Float32Array(e),t,n)}},qy=new Jn,Yo=new F,Gu=new F,ar=class{constructor(e=new F,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):qy.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Yo.subVectors(e,this.center);let t=Yo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Yo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Gu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Yo.copy(e.center).add(Gu)),this.expandByPoint(Yo.copy(e.center).sub(Gu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},$y=0,mi=new bt,Hu=new xn,Jr=new F,ai=new Jn,qo=new Jn,An=new F,on=class i extends Ei{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:$y++}),this.uuid=Xs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(yy(e)?la:aa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new at().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return mi.makeRotationFromQuaternion(e),this.applyMatrix4(mi),this}rotateX(e){return mi.makeRotationX(e),this.applyMatrix4(mi),this}rotateY(e){return mi.makeRotationY(e),this.applyMatrix4(mi),this}rotateZ(e){return mi.makeRotationZ(e),this.applyMatrix4(mi),this}translate(e,t,n){return mi.makeTranslation(e,t,n),this.applyMatrix4(mi),this}scale(e,t,n){return mi.makeScale(e,t,n),this.applyMatrix4(mi),this}lookAt(e){return Hu.lookAt(e),Hu.updateMatrix(),this.applyMatrix4(Hu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Jr).negate(),this.translate(Jr.x,Jr.y,Jr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new jt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&rt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Jn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ht("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(An.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(An),An.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(An)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ht('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ar);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ht("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(e){let n=this.boundingSphere.center;if(ai.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];qo.setFromBufferAttribute(a),this.morphTargetsRelative?(An.addVectors(ai.min,qo.min),ai.expandByPoint(An),An.addVectors(ai.max,qo.max),ai.expandByPoint(An)):(ai.expandByPoint(qo.min),ai.expandByPoint(qo.max))}ai.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)An.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(An));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)An.fromBufferAttribute(a,c),l&&(Jr.fromBufferAttribute(e,c),An.add(Jr)),s=Math.max(s,n.distanceToSquared(An))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ht('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ht("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new En(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let k=0;k<n.count;k++)a[k]=new F,l[k]=new F;let h=new F,u=new F,d=new F,f=new qe,g=new qe,b=new qe,p=new F,m=new F;function v(k,U,L){c[k]=c[U]=c[L]=1,h.fromBufferAttribute(n,k),u.fromBufferAttribute(n,U),d.fromBufferAttribute(n,L),f.fromBufferAttribute(r,k),g.fromBufferAttribute(r,U),b.fromBufferAttribute(r,L),u.sub(h),d.sub(h),g.sub(f),b.sub(f);let G=1/(g.x*b.y-b.x*g.y);isFinite(G)&&(p.copy(u).multiplyScalar(b.y).addScaledVector(d,-g.y).multiplyScalar(G),m.copy(d).multiplyScalar(g.x).addScaledVector(u,-b.x).multiplyScalar(G),a[k].add(p),a[U].add(p),a[L].add(p),l[k].add(m),l[U].add(m),l[L].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let k=0,U=C.length;k<U;++k){let L=C[k],G=L.start,X=L.count;for(let D=G,V=G+X;D<V;D+=3)v(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let M=new F,R=new F,E=new F,y=new F;function A(k){E.fromBufferAttribute(s,k),y.copy(E);let U=a[k];M.copy(U),M.sub(E.multiplyScalar(E.dot(U))).normalize(),R.crossVectors(y,U);let G=R.dot(l[k])<0?-1:1;o.setXYZW(k,M.x,M.y,M.z,G)}for(let k=0,U=n.count;k<U;++k)c[k]&&A(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new En(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new F,r=new F,o=new F,a=new F,l=new F,c=new F,h=new F,u=new F;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),b=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,b),o.fromBufferAttribute(t,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,b),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(b,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)An.fromBufferAttribute(e,t),An.normalize(),e.setXYZ(t,An.x,An.y,An.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,g=0;for(let b=0,p=l.length;b<p;b++){a.isInterleavedBufferAttribute?f=l[b]*a.data.stride+a.offset:f=l[b]*h;for(let m=0;m<h;m++)d[g++]=c[f++]}return new En(d,h,u)}if(this.index===null)return rt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ca=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Ed,this.updateRanges=[],this.version=0,this.uuid=Xs()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Lm(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Lm(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Lm(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Xs()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Hn=new F,fo=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?ch(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Hn.fromBufferAttribute(this,t),Hn.applyMatrix4(e),this.setXYZ(t,Hn.x,Hn.y,Hn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Hn.fromBufferAttribute(this,t),Hn.applyNormalMatrix(e),this.setXYZ(t,Hn.x,Hn.y,Hn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Hn.fromBufferAttribute(this,t),Hn.transformDirection(e),this.setXYZ(t,Hn.x,Hn.y,Hn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){ra("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new En(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){ra("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Id(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Ld(e,this.data.array)}},Vu=new F,Zy=new F,Jy=new at,Wn=class{constructor(e=new F(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Vu.subVectors(n,t).cross(Zy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Vu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Jy.getNormalMatrix(e),s=this.coplanarPoint(Vu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Ky=0,Xi=class extends Ei{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ky++}),this.uuid=Xs(),this.name="",this.type="Material",this.blending=Mo,this.side=Vs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ad,this.blendDst=ld,this.blendEquation=ur,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new nt(0,0,0),this.blendAlpha=0,this.depthFunc=ro,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Tg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Vl,this.stencilZFail=Vl,this.stencilZPass=Vl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){rt(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){rt(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new nt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Wn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new qe().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new qe().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},po=class extends Xi{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new nt(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Kr,$o=new F,jr=new F,Qr=new F,eo=new qe,Zo=new qe,Og=new bt,wl=new F,Jo=new F,Tl=new F,Dm=new qe,Wu=new qe,Nm=new qe,Ci=class extends xn{constructor(e=new po){if(super(),this.isSprite=!0,this.type="Sprite",Kr===void 0){Kr=new on;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new ca(t,5);Kr.setIndex([0,1,2,0,2,3]),Kr.setAttribute("position",new fo(n,3,0,!1)),Kr.setAttribute("uv",new fo(n,2,3,!1))}this.geometry=Kr,this.material=e,this.center=new qe(.5,.5),this.count=1}intersectsFrustum(e){return e.intersectsSprite(this)}raycast(e,t){e.camera===null&&ht('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),jr.setFromMatrixScale(this.matrixWorld),Og.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),Qr.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&jr.multiplyScalar(-Qr.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Al(wl.set(-.5,-.5,0),Qr,o,jr,s,r),Al(Jo.set(.5,-.5,0),Qr,o,jr,s,r),Al(Tl.set(.5,.5,0),Qr,o,jr,s,r),Dm.set(0,0),Wu.set(1,0),Nm.set(1,1);let a=e.ray.intersectTriangle(wl,Jo,Tl,!1,$o);if(a===null&&(Al(Jo.set(-.5,.5,0),Qr,o,jr,s,r),Wu.set(0,1),a=e.ray.intersectTriangle(wl,Tl,Jo,!1,$o),a===null))return;let l=e.ray.origin.distanceTo($o);l<e.near||l>e.far||t.push({distance:l,point:$o.clone(),uv:hs.getInterpolation($o,wl,Jo,Tl,Dm,Wu,Nm,new qe),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}toJSON(e){let t=super.toJSON(e);return t.object.center=this.center.toArray(),t}};function Al(i,e,t,n,s,r){eo.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(Zo.x=r*eo.x-s*eo.y,Zo.y=s*eo.x+r*eo.y):Zo.copy(eo),i.copy(e),i.x+=Zo.x,i.y+=Zo.y,i.applyMatrix4(Og)}var cs=new F,Xu=new F,El=new F,Cl=new F,Os=class{constructor(e=new F,t=new F(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,cs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=cs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(cs.copy(this.origin).addScaledVector(this.direction,t),cs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Xu.copy(e).add(t).multiplyScalar(.5),El.copy(t).sub(e).normalize(),Cl.copy(this.origin).sub(Xu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(El),a=Cl.dot(this.direction),l=-Cl.dot(El),c=Cl.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let b=1/h;u*=b,d*=b,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Xu).addScaledVector(El,d),f}intersectSphere(e,t){if(e.radius<0)return null;cs.subVectors(e.center,this.origin);let n=cs.dot(this.direction),s=cs.dot(cs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,cs)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,b=t.y-o.y,p=t.z-o.z,m=n.x-o.x,v=n.y-o.y,C=n.z-o.z,M=Math.abs(l),R=Math.abs(c),E=Math.abs(h),y,A,k,U,L,G,X,D,V,Y,H,ce;if(M>=R&&M>=E?(k=l,G=u,V=g,ce=m,l>=0?(y=c,A=h,U=d,L=f,X=b,D=p,Y=v,H=C):(y=h,A=c,U=f,L=d,X=p,D=b,Y=C,H=v)):R>=E?(k=c,G=d,V=b,ce=v,c>=0?(y=h,A=l,U=f,L=u,X=p,D=g,Y=C,H=m):(y=l,A=h,U=u,L=f,X=g,D=p,Y=m,H=C)):(k=h,G=f,V=p,ce=C,h>=0?(y=l,A=c,U=u,L=d,X=g,D=b,Y=m,H=v):(y=c,A=l,U=d,L=u,X=b,D=g,Y=v,H=m)),k===0)return null;let q=y/k,j=A/k,ie=1/k,pe=U-q*G,he=L-j*G,ee=X-q*V,ge=D-j*V,Me=Y-q*ce,Le=H-j*ce,Ee=Me*ge-Le*ee,je=pe*Le-he*Me,ut=ee*he-ge*pe;if(s){if(Ee<0||je<0||ut<0)return null}else if((Ee<0||je<0||ut<0)&&(Ee>0||je>0||ut>0))return null;let Je=Ee+je+ut;if(Je===0)return null;let ft=ie*(Ee*G+je*V+ut*ce);return(Je>0?ft<0:ft>0)?null:this.at(ft/Je,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},mo=class extends Xi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fs,this.combine=Mc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Um=new bt,sr=new Os,Rl=new ar,Om=new F,Pl=new F,Il=new F,Ll=new F,Yu=new F,Dl=new F,Fm=new F,Nl=new F,an=class extends xn{constructor(e=new on,t=new mo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Dl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Yu.fromBufferAttribute(u,e),o?Dl.addScaledVector(Yu,h):Dl.addScaledVector(Yu.sub(t),h))}t.add(Dl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Rl.copy(n.boundingSphere),Rl.applyMatrix4(r),sr.copy(e.ray).recast(e.near),!(Rl.containsPoint(sr.origin)===!1&&(sr.intersectSphere(Rl,Om)===null||sr.origin.distanceToSquared(Om)>(e.far-e.near)**2))&&(Um.copy(r).invert(),sr.copy(e.ray).applyMatrix4(Um),!(n.boundingBox!==null&&sr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,sr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,b=d.length;g<b;g++){let p=d[g],m=o[p.materialIndex],v=Math.max(p.start,f.start),C=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let M=v,R=C;M<R;M+=3){let E=a.getX(M),y=a.getX(M+1),A=a.getX(M+2);s=Ul(this,m,e,n,c,h,u,E,y,A),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),b=Math.min(a.count,f.start+f.count);for(let p=g,m=b;p<m;p+=3){let v=a.getX(p),C=a.getX(p+1),M=a.getX(p+2);s=Ul(this,o,e,n,c,h,u,v,C,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,b=d.length;g<b;g++){let p=d[g],m=o[p.materialIndex],v=Math.max(p.start,f.start),C=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let M=v,R=C;M<R;M+=3){let E=M,y=M+1,A=M+2;s=Ul(this,m,e,n,c,h,u,E,y,A),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),b=Math.min(l.count,f.start+f.count);for(let p=g,m=b;p<m;p+=3){let v=p,C=p+1,M=p+2;s=Ul(this,o,e,n,c,h,u,v,C,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function jy(i,e,t,n,s,r,o,a){let l;if(e.side===$n?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===Vs,a),l===null)return null;Nl.copy(a),Nl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Nl);return c<t.near||c>t.far?null:{distance:c,point:Nl.clone(),object:i}}function Ul(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Pl),i.getVertexPosition(l,Il),i.getVertexPosition(c,Ll);let h=jy(i,e,t,n,Pl,Il,Ll,Fm);if(h){let u=new F;hs.getBarycoord(Fm,Pl,Il,Ll,u),s&&(h.uv=hs.getInterpolatedAttribute(s,a,l,c,u,new qe)),r&&(h.uv1=hs.getInterpolatedAttribute(r,a,l,c,u,new qe)),o&&(h.normal=hs.getInterpolatedAttribute(o,a,l,c,u,new F),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new F,materialIndex:0};hs.getNormal(Pl,Il,Ll,d.normal),h.face=d,h.barycoord=u}return h}var ic=class extends qn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Cn,h=Cn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var rr=new ar,Qy=new qe(.5,.5),Ol=new F,Yi=class{constructor(e=new Wn,t=new Wn,n=new Wn,s=new Wn,r=new Wn,o=new Wn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=gi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],b=r[9],p=r[10],m=r[11],v=r[12],C=r[13],M=r[14],R=r[15];if(s[0].setComponents(c-o,f-h,m-g,R-v).normalize(),s[1].setComponents(c+o,f+h,m+g,R+v).normalize(),s[2].setComponents(c+a,f+u,m+b,R+C).normalize(),s[3].setComponents(c-a,f-u,m-b,R-C).normalize(),n)s[4].setComponents(l,d,p,M).normalize(),s[5].setComponents(c-l,f-d,m-p,R-M).normalize();else if(s[4].setComponents(c-l,f-d,m-p,R-M).normalize(),t===gi)s[5].setComponents(c+l,f+d,m+p,R+M).normalize();else if(t===oo)s[5].setComponents(l,d,p,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),rr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),rr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(rr)}intersectsSprite(e){rr.center.set(0,0,0);let t=Qy.distanceTo(e.center);return rr.radius=.7071067811865476+t,rr.applyMatrix4(e.matrixWorld),this.intersectsSphere(rr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Ol.x=s.normal.x>0?e.max.x:e.min.x,Ol.y=s.normal.y>0?e.max.y:e.min.y,Ol.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ol)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Bm=new bt,sc=class i{constructor(){this.coordinateSystem=gi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Bm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Yi),n[s].setFromProjectionMatrix(Bm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Yi),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Fs=class extends Xi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new nt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},rc=new F,oc=new F,zm=new bt,Ko=new Os,Fl=new ar,qu=new F,km=new F,ps=class extends xn{constructor(e=new on,t=new Fs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)rc.fromBufferAttribute(t,s-1),oc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=rc.distanceTo(oc);e.setAttribute("lineDistance",new jt(n,1))}else rt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Fl.copy(n.boundingSphere),Fl.applyMatrix4(s),Fl.radius+=r,e.ray.intersectsSphere(Fl)===!1)return;zm.copy(s).invert(),Ko.copy(e.ray).applyMatrix4(zm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let b=f,p=g-1;b<p;b+=c){let m=h.getX(b),v=h.getX(b+1),C=Bl(this,e,Ko,l,m,v,b);C&&t.push(C)}if(this.isLineLoop){let b=h.getX(g-1),p=h.getX(f),m=Bl(this,e,Ko,l,b,p,g-1);m&&t.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let b=f,p=g-1;b<p;b+=c){let m=Bl(this,e,Ko,l,b,b+1,b);m&&t.push(m)}if(this.isLineLoop){let b=Bl(this,e,Ko,l,g-1,f,g-1);b&&t.push(b)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Bl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(rc.fromBufferAttribute(a,s),oc.fromBufferAttribute(a,r),t.distanceSqToSegment(rc,oc,qu,km)>n)return;qu.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(qu);if(!(c<e.near||c>e.far))return{distance:c,point:km.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Gm=new F,Hm=new F,go=class extends ps{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Gm.fromBufferAttribute(t,s),Hm.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Gm.distanceTo(Hm);e.setAttribute("lineDistance",new jt(n,1))}else rt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ha=class extends qn{constructor(e=[],t=dr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},ua=class extends qn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var ms=class extends qn{constructor(e,t,n=Pi,s,r,o,a=Cn,l=Cn,c,h=ds,u=1){if(h!==ds&&h!==xs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new co(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},da=class extends ms{constructor(e,t=Pi,n=dr,s,r,o=Cn,a=Cn,l,c=ds){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},fa=class extends qn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},qi=class i extends on{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new jt(c,3)),this.setAttribute("normal",new jt(h,3)),this.setAttribute("uv",new jt(u,2));function g(b,p,m,v,C,M,R,E,y,A,k){let U=M/y,L=R/A,G=M/2,X=R/2,D=E/2,V=y+1,Y=A+1,H=0,ce=0,q=new F;for(let j=0;j<Y;j++){let ie=j*L-X;for(let pe=0;pe<V;pe++){let he=pe*U-G;q[b]=he*v,q[p]=ie*C,q[m]=D,c.push(q.x,q.y,q.z),q[b]=0,q[p]=0,q[m]=E>0?1:-1,h.push(q.x,q.y,q.z),u.push(pe/y),u.push(1-j/A),H+=1}}for(let j=0;j<A;j++)for(let ie=0;ie<y;ie++){let pe=d+ie+V*j,he=d+ie+V*(j+1),ee=d+(ie+1)+V*(j+1),ge=d+(ie+1)+V*j;l.push(pe,he,ge),l.push(he,ee,ge),ce+=6}a.addGroup(f,ce,k),f+=ce,d+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var lr=class i extends on{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],g=[],b=[],p=[];for(let m=0;m<h;m++){let v=m*d-o;for(let C=0;C<c;C++){let M=C*u-r;g.push(M,-v,0),b.push(0,0,1),p.push(C/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let C=v+c*m,M=v+c*(m+1),R=v+1+c*(m+1),E=v+1+c*m;f.push(C,M,E),f.push(M,R,E)}this.setIndex(f),this.setAttribute("position",new jt(g,3)),this.setAttribute("normal",new jt(b,3)),this.setAttribute("uv",new jt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var pa=class i extends on{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new F,f=new F,g=new F;for(let b=0;b<=n;b++){let p=o+b/n*a;for(let m=0;m<=s;m++){let v=m/s*r;f.x=(e+t*Math.cos(p))*Math.cos(v),f.y=(e+t*Math.cos(p))*Math.sin(v),f.z=t*Math.sin(p),c.push(f.x,f.y,f.z),d.x=e*Math.cos(v),d.y=e*Math.sin(v),g.subVectors(f,d).normalize(),h.push(g.x,g.y,g.z),u.push(m/s),u.push(b/n)}}for(let b=1;b<=n;b++)for(let p=1;p<=s;p++){let m=(s+1)*b+p-1,v=(s+1)*(b-1)+p-1,C=(s+1)*(b-1)+p,M=(s+1)*b+p;l.push(m,v,M),l.push(v,C,M)}this.setIndex(l),this.setAttribute("position",new jt(c,3)),this.setAttribute("normal",new jt(h,3)),this.setAttribute("uv",new jt(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function pr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Vm(s))s.isRenderTargetTexture?(rt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Vm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function On(i){let e={};for(let t=0;t<i.length;t++){let n=pr(i[t]);for(let s in n)e[s]=n[s]}return e}function Vm(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function ev(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Dd(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Tt.workingColorSpace}var Fg={clone:pr,merge:On},tv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,nv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,$i=class extends Xi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=tv,this.fragmentShader=nv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=pr(e.uniforms),this.uniformsGroups=ev(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new nt().setHex(s.value);break;case"v2":this.uniforms[n].value=new qe().fromArray(s.value);break;case"v3":this.uniforms[n].value=new F().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ct().fromArray(s.value);break;case"m3":this.uniforms[n].value=new at().fromArray(s.value);break;case"m4":this.uniforms[n].value=new bt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},ac=class extends $i{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var gs=class extends Xi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new nt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=lh,this.normalScale=new qe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new fs,this.combine=Mc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},lc=class extends Xi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Sg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},cc=class extends Xi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function to(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function zl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Bs=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},hc=class extends Bs{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ju,endingEnd:Ju}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Ku:r=e,a=2*t-n;break;case ju:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Ku:o=e,l=2*n-t;break;case ju:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),b=g*g,p=b*g,m=-d*p+2*d*b-d*g,v=(1+d)*p+(-1.5-2*d)*b+(-.5+d)*g+1,C=(-1-f)*p+(1.5+f)*b+.5*g,M=f*p-f*b;for(let R=0;R!==a;++R)r[R]=m*o[h+R]+v*o[c+R]+C*o[l+R]+M*o[u+R];return r}},uc=class extends Bs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},dc=class extends Bs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},fc=class extends Bs{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-t)/(s-t),b=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*b+o[l+p]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let b=o[c+g],p=o[l+g],m=f*d+g*2,v=u[m],C=u[m+1],M=e*d+g*2,R=h[M],E=h[M+1],y=sv(n,t,v,R,s);r[g]=Bg(y,b,C,E,p)}return r}};function Bg(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function iv(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function sv(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=Bg(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=iv(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var hi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=to(t,this.TimeBufferType),this.values=to(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:to(e.times,Array),values:to(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),zl(e.settings)&&(n.settings={inTangents:to(e.settings.inTangents,Array),outTangents:to(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new dc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new uc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new hc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new fc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ta:t=this.InterpolantFactoryMethodDiscrete;break;case Ql:t=this.InterpolantFactoryMethodLinear;break;case Hl:t=this.InterpolantFactoryMethodSmooth;break;case Zu:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return rt("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ta;case this.InterpolantFactoryMethodLinear:return Ql;case this.InterpolantFactoryMethodSmooth:return Hl;case this.InterpolantFactoryMethodBezier:return Zu}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;zl(this.settings)&&(Wm(this.settings.inTangents,e),Wm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;zl(this.settings)&&(Xm(this.settings.inTangents,e),Xm(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ht("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ht("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ht("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){ht("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&vy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ht("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Hl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let g=0;g!==n;++g){let b=t[u+g];if(b!==t[d+g]||b!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,zl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Wm(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Xm(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}hi.prototype.ValueTypeName="";hi.prototype.TimeBufferType=Float32Array;hi.prototype.ValueBufferType=Float32Array;hi.prototype.DefaultInterpolation=Ql;var zs=class extends hi{constructor(e,t,n){super(e,t,n)}};zs.prototype.ValueTypeName="bool";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=ta;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var pc=class extends hi{constructor(e,t,n,s){super(e,t,n,s)}};pc.prototype.ValueTypeName="color";var mc=class extends hi{constructor(e,t,n,s){super(e,t,n,s)}};mc.prototype.ValueTypeName="number";var gc=class extends Bs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)li.slerpFlat(r,0,o,c-a,o,c,l);return r}},ma=class extends hi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new gc(this.times,this.values,this.getValueSize(),e)}};ma.prototype.ValueTypeName="quaternion";ma.prototype.InterpolantFactoryMethodSmooth=void 0;var ks=class extends hi{constructor(e,t,n){super(e,t,n)}};ks.prototype.ValueTypeName="string";ks.prototype.ValueBufferType=Array;ks.prototype.DefaultInterpolation=ta;ks.prototype.InterpolantFactoryMethodLinear=void 0;ks.prototype.InterpolantFactoryMethodSmooth=void 0;var _c=class extends hi{constructor(e,t,n,s){super(e,t,n,s)}};_c.prototype.ValueTypeName="vector";var xc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},zg=new xc,yc=class{constructor(e){this.manager=e!==void 0?e:zg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};yc.DEFAULT_MATERIAL_NAME="__DEFAULT";var _o=class extends xn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new nt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},ga=class extends _o{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(xn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new nt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},$u=new bt,Ym=new F,qm=new F,vc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new qe(512,512),this.mapType=Kn,this.map=null,this.mapPass=null,this.matrix=new bt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Yi,this._frameExtents=new qe(1,1),this._viewportCount=1,this._viewports=[new Ct(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Ym.setFromMatrixPosition(e.matrixWorld),t.position.copy(Ym),qm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(qm),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){$u.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix($u,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===oo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply($u)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},kl=new F,Gl=new li,Vi=new F,cr=class extends xn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new bt,this.projectionMatrix=new bt,this.projectionMatrixInverse=new bt,this.coordinateSystem=gi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(kl,Gl,Vi),Vi.x===1&&Vi.y===1&&Vi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(kl,Gl,Vi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(kl,Gl,Vi),Vi.x===1&&Vi.y===1&&Vi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(kl,Gl,Vi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Us=new F,$m=new qe,Zm=new qe,Xn=class extends cr{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=lo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Qo*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return lo*2*Math.atan(Math.tan(Qo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Us.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Us.x,Us.y).multiplyScalar(-e/Us.z),Us.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Us.x,Us.y).multiplyScalar(-e/Us.z)}getViewSize(e,t){return this.getViewBounds(e,$m,Zm),t.subVectors(Zm,$m)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Qo*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ri=class extends cr{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Qu=class extends vc{constructor(){super(new Ri(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},_a=class extends _o{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(xn.DEFAULT_UP),this.updateMatrix(),this.target=new xn,this.shadow=new Qu}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},xa=class extends _o{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var no=-90,io=1,xo=class extends xn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Xn(no,io,e,t);s.layers=this.layers,this.add(s);let r=new Xn(no,io,e,t);r.layers=this.layers,this.add(r);let o=new Xn(no,io,e,t);o.layers=this.layers,this.add(o);let a=new Xn(no,io,e,t);a.layers=this.layers,this.add(a);let l=new Xn(no,io,e,t);l.layers=this.layers,this.add(l);let c=new Xn(no,io,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===gi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===oo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let b=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=b,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},bc=class extends Xn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Nd="\\[\\]\\.:\\/",rv=new RegExp("["+Nd+"]","g"),Ud="[^"+Nd+"]",ov="[^"+Nd.replace("\\.","")+"]",av=/((?:WC+[\/:])*)/.source.replace("WC",Ud),lv=/(WCOD+)?/.source.replace("WCOD",ov),cv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ud),hv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ud),uv=new RegExp("^"+av+lv+cv+hv+"$"),dv=["material","materials","bones","map"],ed=class{constructor(e,t,n){let s=n||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Zt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(rv,"")}static parseTrackName(e){let t=uv.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);dv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){rt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){ht("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ht("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ht("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ht("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ht("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){ht("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){ht("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;ht("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){ht("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ht("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=ed;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var kA=new Float32Array(1);var Jm=new bt,ya=class{constructor(e,t,n=0,s=1/0){this.ray=new Os(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new ho,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):ht("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Jm.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Jm),this}intersectObject(e,t=!0,n=[]){return td(e,this,n,t),n.sort(Km),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)td(e[s],this,n,t);return n.sort(Km),n}};function Km(i,e){return i.distance-e.distance}function td(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)td(r[o],e,t,!0)}}var yo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=vt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(vt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var nd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}},jm=new qe,vo=class{constructor(e=new qe(1/0,1/0),t=new qe(-1/0,-1/0)){this.isBox2=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=jm.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=1/0,this.max.x=this.max.y=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y}getCenter(e){return this.isEmpty()?e.set(0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,jm).distanceTo(e)}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}};var va=class extends go{constructor(e=10,t=10,n=4473924,s=8947848){n=new nt(n),s=new nt(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,g=-a;d<=t;d++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let b=d===r?n:s;b.toArray(c,f),f+=3,b.toArray(c,f),f+=3,b.toArray(c,f),f+=3,b.toArray(c,f),f+=3}let h=new on;h.setAttribute("position",new jt(l,3)),h.setAttribute("color",new jt(c,3));let u=new Fs({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ba=class extends Ei{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Od(i,e,t,n){let s=fv(n);switch(t){case bd:return i*e;case Sd:return i*e/s.components*s.byteLength;case Rc:return i*e/s.components*s.byteLength;case Ws:return i*e*2/s.components*s.byteLength;case Pc:return i*e*2/s.components*s.byteLength;case Md:return i*e*3/s.components*s.byteLength;case Di:return i*e*4/s.components*s.byteLength;case Ic:return i*e*4/s.components*s.byteLength;case wa:case Ta:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Aa:case Ea:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Dc:case Uc:return Math.max(i,16)*Math.max(e,8)/4;case Lc:case Nc:return Math.max(i,8)*Math.max(e,8)/2;case Oc:case Fc:case zc:case kc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Bc:case Ca:case Gc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Hc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Vc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Wc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Xc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Yc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case qc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case $c:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Zc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Jc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Kc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case jc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Qc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case eh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case th:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case nh:case ih:case sh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case rh:case oh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ra:case ah:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function fv(i){switch(i){case Kn:case _d:return{byteLength:1,components:1};case wo:case xd:case Li:return{byteLength:2,components:1};case Ec:case Cc:return{byteLength:2,components:4};case Pi:case Ac:case Ii:return{byteLength:4,components:1};case yd:case vd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?rt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function a0(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function yv(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],b=u[f];b.start<=g.start+g.count+1?g.count=Math.max(g.count,b.start+b.count-g.start):(++d,u[d]=b)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let b=u[f];i.bufferSubData(c,b.start*h.BYTES_PER_ELEMENT,h,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var vv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,bv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Mv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Sv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,wv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Tv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Av=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Ev=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Cv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Rv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Pv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Iv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Lv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Dv="",Nv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Uv=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Ov=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Fv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Bv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,zv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,kv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Gv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Hv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Vv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Wv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Xv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Yv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,qv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,$v=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Zv="gl_FragColor = linearToOutputTexel( gl_FragColor );",Jv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Kv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,jv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Qv=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,eb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,tb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,nb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,ib=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,sb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,rb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ob="",ab=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,lb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,cb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,hb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,ub=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,db="",fb="",pb="",mb="",gb="",_b="",xb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,yb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,vb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,bb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Mb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Sb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,wb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Tb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ab=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Eb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Cb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Rb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Pb="",Ib="",Lb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Db=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Nb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ub=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Ob=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Fb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Bb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,zb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,kb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Gb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Hb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Vb="",Wb="",Xb="",Yb="",qb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,$b=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Zb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Jb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Kb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,jb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Qb="",eM="",tM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,nM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,iM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,sM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,rM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,oM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,aM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,lM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,cM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,hM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,uM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,dM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,fM="",pM="",mM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,gM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,_M=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,xM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,yM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,vM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,MM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,SM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,TM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,AM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,EM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,CM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,RM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,PM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,IM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,LM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,DM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,NM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,UM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,OM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,FM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,BM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,zM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,kM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,GM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,HM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,VM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,WM=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XM=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,YM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qM=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,$M=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ZM=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,JM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,KM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,jM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,_t={alphahash_fragment:vv,alphahash_pars_fragment:bv,alphamap_fragment:Mv,alphamap_pars_fragment:Sv,alphatest_fragment:wv,alphatest_pars_fragment:Tv,aomap_fragment:Av,aomap_pars_fragment:Ev,batching_pars_vertex:Cv,batching_vertex:Rv,begin_vertex:Pv,beginnormal_vertex:Iv,bsdfs:Lv,iridescence_fragment:Dv,bumpmap_pars_fragment:Nv,clipping_planes_fragment:Uv,clipping_planes_pars_fragment:Ov,clipping_planes_pars_vertex:Fv,clipping_planes_vertex:Bv,color_fragment:zv,color_pars_fragment:kv,color_pars_vertex:Gv,color_vertex:Hv,common:Vv,defaultnormal_vertex:Wv,displacementmap_pars_vertex:Xv,displacementmap_vertex:Yv,emissivemap_fragment:qv,emissivemap_pars_fragment:$v,colorspace_fragment:Zv,colorspace_pars_fragment:Jv,envmap_fragment:Kv,envmap_common_pars_fragment:jv,envmap_pars_fragment:Qv,envmap_pars_vertex:eb,envmap_physical_pars_fragment:ub,envmap_vertex:tb,fog_vertex:nb,fog_pars_vertex:ib,fog_fragment:sb,fog_pars_fragment:rb,gradientmap_pars_fragment:ob,lightmap_pars_fragment:ab,lights_lambert_fragment:lb,lights_lambert_pars_fragment:cb,lights_pars_begin:hb,lights_toon_fragment:db,lights_toon_pars_fragment:fb,lights_phong_fragment:pb,lights_phong_pars_fragment:mb,lights_physical_fragment:gb,lights_physical_pars_fragment:_b,lights_fragment_begin:xb,lights_fragment_maps:yb,lights_fragment_end:vb,lightprobes_pars_fragment:bb,logdepthbuf_fragment:Mb,logdepthbuf_pars_fragment:Sb,logdepthbuf_pars_vertex:wb,logdepthbuf_vertex:Tb,map_fragment:Ab,map_pars_fragment:Eb,map_particle_fragment:Cb,map_particle_pars_fragment:Rb,metalnessmap_fragment:Pb,metalnessmap_pars_fragment:Ib,morphinstance_vertex:Lb,morphcolor_vertex:Db,morphnormal_vertex:Nb,morphtarget_pars_vertex:Ub,morphtarget_vertex:Ob,normal_fragment_begin:Fb,normal_fragment_maps:Bb,normal_pars_fragment:zb,normal_pars_vertex:kb,normal_vertex:Gb,normalmap_pars_fragment:Hb,clearcoat_normal_fragment_begin:Vb,clearcoat_normal_fragment_maps:Wb,clearcoat_pars_fragment:Xb,iridescence_pars_fragment:Yb,opaque_fragment:qb,packing:$b,premultiplied_alpha_fragment:Zb,project_vertex:Jb,dithering_fragment:Kb,dithering_pars_fragment:jb,roughnessmap_fragment:Qb,roughnessmap_pars_fragment:eM,shadowmap_pars_fragment:tM,shadowmap_pars_vertex:nM,shadowmap_vertex:iM,shadowmask_pars_fragment:sM,skinbase_vertex:rM,skinning_pars_vertex:oM,skinning_vertex:aM,skinnormal_vertex:lM,specularmap_fragment:cM,specularmap_pars_fragment:hM,tonemapping_fragment:uM,tonemapping_pars_fragment:dM,transmission_fragment:fM,transmission_pars_fragment:pM,uv_pars_fragment:mM,uv_pars_vertex:gM,uv_vertex:_M,worldpos_vertex:xM,background_vert:yM,background_frag:vM,backgroundCube_vert:bM,backgroundCube_frag:MM,cube_vert:SM,cube_frag:wM,depth_vert:TM,depth_frag:AM,distance_vert:EM,distance_frag:CM,equirect_vert:RM,equirect_frag:PM,linedashed_vert:IM,linedashed_frag:LM,meshbasic_vert:DM,meshbasic_frag:NM,meshlambert_vert:UM,meshlambert_frag:OM,meshmatcap_vert:FM,meshmatcap_frag:BM,meshnormal_vert:zM,meshnormal_frag:kM,meshphong_vert:GM,meshphong_frag:HM,meshphysical_vert:VM,meshphysical_frag:WM,meshtoon_vert:XM,meshtoon_frag:YM,points_vert:qM,points_frag:$M,shadow_vert:ZM,shadow_frag:JM,sprite_vert:KM,sprite_frag:jM},ze={common:{diffuse:{value:new nt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new at},alphaMap:{value:null},alphaMapTransform:{value:new at},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new at}},envmap:{envMap:{value:null},envMapRotation:{value:new at},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new at}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new at}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new at},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new at},normalScale:{value:new qe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new at},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new at}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new at}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new at}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new nt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new nt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new at},alphaTest:{value:0},uvTransform:{value:new at}},sprite:{diffuse:{value:new nt(16777215)},opacity:{value:1},center:{value:new qe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new at},alphaMap:{value:null},alphaMapTransform:{value:new at},alphaTest:{value:0}}},Ki={basic:{uniforms:On([ze.common,ze.specularmap,ze.envmap,ze.aomap,ze.lightmap,ze.fog]),vertexShader:_t.meshbasic_vert,fragmentShader:_t.meshbasic_frag},lambert:{uniforms:On([ze.common,ze.specularmap,ze.envmap,ze.aomap,ze.lightmap,ze.emissivemap,ze.bumpmap,ze.normalmap,ze.displacementmap,ze.fog,ze.lights,{emissive:{value:new nt(0)},envMapIntensity:{value:1}}]),vertexShader:_t.meshlambert_vert,fragmentShader:_t.meshlambert_frag},phong:{uniforms:On([ze.common,ze.specularmap,ze.envmap,ze.aomap,ze.lightmap,ze.emissivemap,ze.bumpmap,ze.normalmap,ze.displacementmap,ze.fog,ze.lights,{emissive:{value:new nt(0)},specular:{value:new nt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:_t.meshphong_vert,fragmentShader:_t.meshphong_frag},standard:{uniforms:On([ze.common,ze.envmap,ze.aomap,ze.lightmap,ze.emissivemap,ze.bumpmap,ze.normalmap,ze.displacementmap,ze.roughnessmap,ze.metalnessmap,ze.fog,ze.lights,{emissive:{value:new nt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag},toon:{uniforms:On([ze.common,ze.aomap,ze.lightmap,ze.emissivemap,ze.bumpmap,ze.normalmap,ze.displacementmap,ze.gradientmap,ze.fog,ze.lights,{emissive:{value:new nt(0)}}]),vertexShader:_t.meshtoon_vert,fragmentShader:_t.meshtoon_frag},matcap:{uniforms:On([ze.common,ze.bumpmap,ze.normalmap,ze.displacementmap,ze.fog,{matcap:{value:null}}]),vertexShader:_t.meshmatcap_vert,fragmentShader:_t.meshmatcap_frag},points:{uniforms:On([ze.points,ze.fog]),vertexShader:_t.points_vert,fragmentShader:_t.points_frag},dashed:{uniforms:On([ze.common,ze.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:_t.linedashed_vert,fragmentShader:_t.linedashed_frag},depth:{uniforms:On([ze.common,ze.displacementmap]),vertexShader:_t.depth_vert,fragmentShader:_t.depth_frag},normal:{uniforms:On([ze.common,ze.bumpmap,ze.normalmap,ze.displacementmap,{opacity:{value:1}}]),vertexShader:_t.meshnormal_vert,fragmentShader:_t.meshnormal_frag},sprite:{uniforms:On([ze.sprite,ze.fog]),vertexShader:_t.sprite_vert,fragmentShader:_t.sprite_frag},background:{uniforms:{uvTransform:{value:new at},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:_t.background_vert,fragmentShader:_t.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new at}},vertexShader:_t.backgroundCube_vert,fragmentShader:_t.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:_t.cube_vert,fragmentShader:_t.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:_t.equirect_vert,fragmentShader:_t.equirect_frag},distance:{uniforms:On([ze.common,ze.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:_t.distance_vert,fragmentShader:_t.distance_frag},shadow:{uniforms:On([ze.lights,ze.fog,{color:{value:new nt(0)},opacity:{value:1}}]),vertexShader:_t.shadow_vert,fragmentShader:_t.shadow_frag}};Ki.physical={uniforms:On([Ki.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new at},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new at},clearcoatNormalScale:{value:new qe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new at},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new at},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new at},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new at},sheen:{value:0},sheenColor:{value:new nt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new at},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new at},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new at},transmissionSamplerSize:{value:new qe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new at},attenuationDistance:{value:0},attenuationColor:{value:new nt(0)},specularColor:{value:new nt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new at},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new at},anisotropyVector:{value:new qe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new at}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag};var uh={r:0,b:0,g:0},QM=new bt,l0=new at;l0.set(-1,0,0,0,1,0,0,0,1);function eS(i,e,t,n,s,r){let o=new nt(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(v){let C=v.isScene===!0?v.background:null;if(C&&C.isTexture){let M=v.backgroundBlurriness>0;C=e.get(C,M)}return C}function g(v){let C=!1,M=f(v);M===null?p(o,a):M&&M.isColor&&(p(M,1),C=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function b(v,C){let M=f(C);M&&M.isCubeTexture?(c===void 0&&(c=new an(new qi(1,1,1),new $i({name:"BackgroundCubeMaterial",uniforms:pr(Ki.backgroundCube.uniforms),vertexShader:Ki.backgroundCube.vertexShader,fragmentShader:Ki.backgroundCube.fragmentShader,side:$n,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,E,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(QM.makeRotationFromEuler(C.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(l0),c.material.toneMapped=Tt.getTransfer(M.colorSpace)!==Nt,(h!==M||u!==M.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new an(new lr(2,2),new $i({name:"BackgroundMaterial",uniforms:pr(Ki.background.uniforms),vertexShader:Ki.background.vertexShader,fragmentShader:Ki.background.fragmentShader,side:Vs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=Tt.getTransfer(M.colorSpace)!==Nt,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,C){v.getRGB(uh,Dd(i)),t.buffers.color.setClear(uh.r,uh.g,uh.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,C=1){o.set(v),a=C,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:g,addToRenderList:b,dispose:m}}function tS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(L,G,X,D,V){let Y=!1,H=u(L,D,X,G);r!==H&&(r=H,c(r.object)),Y=f(L,D,X,V),Y&&g(L,D,X,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,M(L,G,X,D),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function u(L,G,X,D){let V=D.wireframe===!0,Y=n[G.id];Y===void 0&&(Y={},n[G.id]=Y);let H=L.isInstancedMesh===!0?L.id:0,ce=Y[H];ce===void 0&&(ce={},Y[H]=ce);let q=ce[X.id];q===void 0&&(q={},ce[X.id]=q);let j=q[V];return j===void 0&&(j=d(l()),q[V]=j),j}function d(L){let G=[],X=[],D=[];for(let V=0;V<t;V++)G[V]=0,X[V]=0,D[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:X,attributeDivisors:D,object:L,attributes:{},index:null}}function f(L,G,X,D){let V=r.attributes,Y=G.attributes,H=0,ce=X.getAttributes();for(let q in ce)if(ce[q].location>=0){let ie=V[q],pe=Y[q];if(pe===void 0&&(q==="instanceMatrix"&&L.instanceMatrix&&(pe=L.instanceMatrix),q==="instanceColor"&&L.instanceColor&&(pe=L.instanceColor)),ie===void 0||ie.attribute!==pe||pe&&ie.data!==pe.data)return!0;H++}return r.attributesNum!==H||r.index!==D}function g(L,G,X,D){let V={},Y=G.attributes,H=0,ce=X.getAttributes();for(let q in ce)if(ce[q].location>=0){let ie=Y[q];ie===void 0&&(q==="instanceMatrix"&&L.instanceMatrix&&(ie=L.instanceMatrix),q==="instanceColor"&&L.instanceColor&&(ie=L.instanceColor));let pe={};pe.attribute=ie,ie&&ie.data&&(pe.data=ie.data),V[q]=pe,H++}r.attributes=V,r.attributesNum=H,r.index=D}function b(){let L=r.newAttributes;for(let G=0,X=L.length;G<X;G++)L[G]=0}function p(L){m(L,0)}function m(L,G){let X=r.newAttributes,D=r.enabledAttributes,V=r.attributeDivisors;X[L]=1,D[L]===0&&(i.enableVertexAttribArray(L),D[L]=1),V[L]!==G&&(i.vertexAttribDivisor(L,G),V[L]=G)}function v(){let L=r.newAttributes,G=r.enabledAttributes;for(let X=0,D=G.length;X<D;X++)G[X]!==L[X]&&(i.disableVertexAttribArray(X),G[X]=0)}function C(L,G,X,D,V,Y,H){H===!0?i.vertexAttribIPointer(L,G,X,V,Y):i.vertexAttribPointer(L,G,X,D,V,Y)}function M(L,G,X,D){b();let V=D.attributes,Y=X.getAttributes(),H=G.defaultAttributeValues;for(let ce in Y){let q=Y[ce];if(q.location>=0){let j=V[ce];if(j===void 0&&(ce==="instanceMatrix"&&L.instanceMatrix&&(j=L.instanceMatrix),ce==="instanceColor"&&L.instanceColor&&(j=L.instanceColor)),j!==void 0){let ie=j.normalized,pe=j.itemSize,he=e.get(j);if(he===void 0)continue;let ee=he.buffer,ge=he.type,Me=he.bytesPerElement,Le=ge===i.INT||ge===i.UNSIGNED_INT||j.gpuType===Ac;if(j.isInterleavedBufferAttribute){let Ee=j.data,je=Ee.isInterleavedBuffer===!0?Ee.stride:Ee.itemSize,ut=j.offset;if(Ee.isInstancedInterleavedBuffer||Ee.isInstancedBufferAttribute){for(let Je=0;Je<q.locationSize;Je++)m(q.location+Je,Ee.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Ee.meshPerAttribute*Ee.count)}else for(let Je=0;Je<q.locationSize;Je++)p(q.location+Je);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Je=0;Je<q.locationSize;Je++)C(q.location+Je,pe/q.locationSize,ge,ie,je*Me,(ut+pe/q.locationSize*Je)*Me,Le)}else{if(j.isInstancedBufferAttribute){for(let Ee=0;Ee<q.locationSize;Ee++)m(q.location+Ee,j.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let Ee=0;Ee<q.locationSize;Ee++)p(q.location+Ee);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Ee=0;Ee<q.locationSize;Ee++)C(q.location+Ee,pe/q.locationSize,ge,ie,pe*Me,pe/q.locationSize*Ee*Me,Le)}}else if(H!==void 0){let ie=H[ce];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(q.location,ie);break;case 3:i.vertexAttrib3fv(q.location,ie);break;case 4:i.vertexAttrib4fv(q.location,ie);break;default:i.vertexAttrib1fv(q.location,ie)}}}}v()}function R(){k();for(let L in n){let G=n[L];for(let X in G){let D=G[X];for(let V in D){let Y=D[V];for(let H in Y)h(Y[H].object),delete Y[H];delete D[V]}}delete n[L]}}function E(L){if(n[L.id]===void 0)return;let G=n[L.id];for(let X in G){let D=G[X];for(let V in D){let Y=D[V];for(let H in Y)h(Y[H].object),delete Y[H];delete D[V]}}delete n[L.id]}function y(L){for(let G in n){let X=n[G];for(let D in X){let V=X[D];if(V[L.id]===void 0)continue;let Y=V[L.id];for(let H in Y)h(Y[H].object),delete Y[H];delete V[L.id]}}}function A(L){for(let G in n){let X=n[G],D=L.isInstancedMesh===!0?L.id:0,V=X[D];if(V!==void 0){for(let Y in V){let H=V[Y];for(let ce in H)h(H[ce].object),delete H[ce];delete V[Y]}delete X[D],Object.keys(X).length===0&&delete n[G]}}}function k(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:U,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:A,releaseStatesOfProgram:y,initAttributes:b,enableAttribute:p,disableUnusedAttributes:v}}function nS(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function iS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Di&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let A=y===Li&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==Kn&&y!==Ii&&!A&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(rt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&rt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&rt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),C=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:b,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:v,maxVaryings:C,maxFragmentUniforms:M,maxSamples:R,samples:E}}function sS(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Wn,a=new at,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,b=u.clipIntersection,p=u.clipShadows,m=i.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let v=r?0:n,C=v*4,M=m.clippingState||null;l.value=M,M=h(g,d,C,f);for(let R=0;R!==C;++R)M[R]=t[R];m.clippingState=M,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,g){let b=u!==null?u.length:0,p=null;if(b!==0){if(p=l.value,g!==!0||p===null){let m=f+b*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<m)&&(p=new Float32Array(m));for(let C=0,M=f;C!==b;++C,M+=4)o.copy(u[C]).applyMatrix4(v,a),o.normal.toArray(p,M),p[M+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,p}}var La=class extends ci{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ha(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new qi(5,5,5),r=new $i({name:"CubemapFromEquirect",uniforms:pr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:$n,blending:hr});r.uniforms.tEquirect.value=t;let o=new an(s,r),a=t.minFilter;return t.minFilter===_s&&(t.minFilter=Yn),new xo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},kg=256,rS=3,oS=20,c0=256,h0=16,aS=3,lS=new F,cS=new nt,fh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new xo(1,10,null),this._boxMesh=new an(new qi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=lS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(cS));let p=new xo(n,s,h);return p.position.copy(a),p.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=b,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Vg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Hg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(kg,Pd(e))}_fromTexture(e,t){e.mapping===dr||e.mapping===So?this._setSize(e.image.length===0?kg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Gg(e,!1,!1),n=Math.log2(e)-rS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Gg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===dr||e.mapping===So?(this._cubemapMaterial===null&&(this._cubemapMaterial=Vg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Hg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=hS(),this._integrationMaterial=uS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/h0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-aS)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(c0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=dS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function Gg(i,e,t){return new La(i,{minFilter:_s,generateMipmaps:e,type:Li,colorSpace:na,depthBuffer:t})}function Na(i,e,t){return new $i({name:i,uniforms:e,vertexShader:_t.cube_vert,fragmentShader:t,side:$n,blending:hr,depthTest:!1,depthWrite:!1})}function hS(){return Na("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${c0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function uS(){return Na("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:h0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function dS(){return Na("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${oS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Hg(){return Na("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Vg(){return Na("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function fS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Sc||f===wc)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let b=new La(g.height);return b.fromEquirectangularTexture(i,d),e.set(d,b),d.addEventListener("dispose",c),a(b.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===Sc||f===wc,b=f===dr||f===So;if(g||b){let p=t.get(d),m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new fh(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let v=d.image;return g&&v&&v.height>0||b&&v&&l(v)?(n===null&&(n=new fh(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,f){return f===Sc?d.mapping=dr:f===wc&&(d.mapping=So),d}function l(d){let f=0,g=6;for(let b=0;b<g;b++)d[b]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function pS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&jo("WebGLRenderer: "+n+" extension not supported."),s}}}function mS(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let b=r.get(g);b&&(e.remove(b),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,b){return s[b.id]!==void 0||(b.addEventListener("dispose",a),s[b.id]=new WeakRef(b),o.register(b,b.id,b),t.memory.geometries++),b}function h(g){let b=g.attributes;for(let p in b)e.update(b[p],i.ARRAY_BUFFER)}function u(g){let b=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let v=b!==null?b.array.length:p.array.length/3-1,C=p.count>=65535?la:aa,M=new C(Math.ceil(v/3)*6,1),R=M.array;if(b!==null){let y=b.array;m=b.version;for(let A=0,k=0;A<v;A+=3){let U=y[A+0],L=y[A+1],G=y[A+2];R[k++]=U,R[k++]=L,R[k++]=L,R[k++]=G,R[k++]=G,R[k++]=U}}else{m=p.version;for(let y=0,A=0;y<v;y+=3){let k=y+0,U=y+1,L=y+2;R[A++]=k,R[A++]=U,R[A++]=U,R[A++]=L,R[A++]=L,R[A++]=k}}M.version=m;let E=r.get(g);E&&e.remove(E),r.set(g,M)}function d(g){let b=r.get(g);if(b){let p=g.index;p!==null&&b.version<p.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let b=s[g].deref();b!==void 0&&l(b)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function gS(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),t.update(d,n,f))}function h(u,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let b=0;for(let p=0;p<f;p++)b+=d[p];t.update(b,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function _S(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:ht("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function xS(i,e,t){let n=new WeakMap,s=new Ct;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let k=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",k)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],C=0;f===!0&&(C=1),g===!0&&(C=2),b===!0&&(C=3);let M=a.attributes.position.count*C,R=1;M>e.maxTextureSize&&(R=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let E=new Float32Array(M*R*4*u),y=new oa(E,M,R,u);y.type=Ii,y.needsUpdate=!0;let A=C*4;for(let U=0;U<u;U++){let L=p[U],G=m[U],X=v[U],D=M*R*4*U;for(let V=0;V<L.count;V++){let Y=V*A;f===!0&&(s.fromBufferAttribute(L,V),E[D+Y+0]=s.x,E[D+Y+1]=s.y,E[D+Y+2]=s.z,E[D+Y+3]=0),g===!0&&(s.fromBufferAttribute(G,V),E[D+Y+4]=s.x,E[D+Y+5]=s.y,E[D+Y+6]=s.z,E[D+Y+7]=0),b===!0&&(s.fromBufferAttribute(X,V),E[D+Y+8]=s.x,E[D+Y+9]=s.y,E[D+Y+10]=s.z,E[D+Y+11]=X.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new qe(M,R)},n.set(a,d),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let b=0;b<c.length;b++)f+=c[b];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function yS(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var vS={[cd]:"LINEAR_TONE_MAPPING",[hd]:"REINHARD_TONE_MAPPING",[ud]:"CINEON_TONE_MAPPING",[dd]:"ACES_FILMIC_TONE_MAPPING",[pd]:"AGX_TONE_MAPPING",[md]:"NEUTRAL_TONE_MAPPING",[fd]:"CUSTOM_TONE_MAPPING"};function bS(i,e,t,n,s,r){let o=new ci(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new on;h.setAttribute("position",new jt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new jt([0,2,0,0,2,0],2));let u=new ac({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new an(h,u),f=new Ri(-1,1,1,-1,0,1),g=null,b=null,p=!1,m,v=null,C=[],M=!1;this.setSize=function(R,E){o.setSize(R,E),a!==null&&a.setSize(R,E),l!==null&&l.setSize(R,E);for(let y=0;y<C.length;y++){let A=C[y];A.setSize&&A.setSize(R,E)}},this.setEffects=function(R){C=R,M=C.length>0&&C[0].isRenderPass===!0;let E=o.width,y=o.height;C.length>0&&a===null&&(a=new ci(E,y,{type:Li,depthBuffer:!1,stencilBuffer:!1}),l=new ci(E,y,{type:Li,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&C.some(k=>k.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new ms(E,y),r===!0&&(c.format=xs,c.type=fr)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let k=0;k<C.length;k++){let U=C[k];U.setSize&&U.setSize(E,y),A&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(R,E){if(p||R.toneMapping===Zi&&C.length===0)return!1;if(v=E,E!==null){let y=E.width,A=E.height;(o.width!==y||o.height!==A)&&this.setSize(y,A)}return M===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=Zi,!0},this.hasRenderPass=function(){return M},this.end=function(R,E){R.toneMapping=m,p=!0;let y=o,A=a;for(let k=0;k<C.length;k++){let U=C[k];U.enabled!==!1&&(U.render(R,A,y,E),U.needsSwap!==!1&&(y=A,A=A===a?l:a))}if(g!==R.outputColorSpace||b!==R.toneMapping){g=R.outputColorSpace,b=R.toneMapping,u.defines={},Tt.getTransfer(g)===Nt&&(u.defines.SRGB_TRANSFER="");let k=vS[b];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,R.setRenderTarget(v),R.render(d,f),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var u0=new qn,d0=new ms(1,1),f0=new da(1),p0=new oa,m0=new nc,g0=new ha,Wg=[],Xg=[],Yg=new Float32Array(16),qg=new Float32Array(9),$g=new Float32Array(4);function Ao(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Wg[s];if(r===void 0&&(r=new Float32Array(s),Wg[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function yn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function vn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function ph(i,e){let t=Xg[e];t===void 0&&(t=new Int32Array(e),Xg[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function MS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function SS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;i.uniform2fv(this.addr,e),vn(t,e)}}function wS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(yn(t,e))return;i.uniform3fv(this.addr,e),vn(t,e)}}function TS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;i.uniform4fv(this.addr,e),vn(t,e)}}function AS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(yn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,n))return;$g.set(n),i.uniformMatrix2fv(this.addr,!1,$g),vn(t,n)}}function ES(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(yn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,n))return;qg.set(n),i.uniformMatrix3fv(this.addr,!1,qg),vn(t,n)}}function CS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(yn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),vn(t,e)}else{if(yn(t,n))return;Yg.set(n),i.uniformMatrix4fv(this.addr,!1,Yg),vn(t,n)}}function RS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function PS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;i.uniform2iv(this.addr,e),vn(t,e)}}function IS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(yn(t,e))return;i.uniform3iv(this.addr,e),vn(t,e)}}function LS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;i.uniform4iv(this.addr,e),vn(t,e)}}function DS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function NS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yn(t,e))return;i.uniform2uiv(this.addr,e),vn(t,e)}}function US(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(yn(t,e))return;i.uniform3uiv(this.addr,e),vn(t,e)}}function OS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yn(t,e))return;i.uniform4uiv(this.addr,e),vn(t,e)}}function mh(i){return i.version===0&&(i.compareFunction=Ad,i.needsUpdate=!0),i}function FS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=mh(d0):r=u0,t.setTexture2D(e||r,s)}function BS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||m0,s)}function zS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=mh(f0):r=g0,t.setTextureCube(e||r,s)}function kS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||p0,s)}function GS(i){switch(i){case 5126:return MS;case 35664:return SS;case 35665:return wS;case 35666:return TS;case 35674:return AS;case 35675:return ES;case 35676:return CS;case 5124:case 35670:return RS;case 35667:case 35671:return PS;case 35668:case 35672:return IS;case 35669:case 35673:return LS;case 5125:return DS;case 36294:return NS;case 36295:return US;case 36296:return OS;case 35678:case 36198:case 36298:case 36306:case 35682:return FS;case 35679:case 36299:case 36307:return BS;case 35680:case 36300:case 36308:case 36293:return zS;case 36289:case 36303:case 36311:case 36292:return kS}}function HS(i,e){i.uniform1fv(this.addr,e)}function VS(i,e){let t=Ao(e,this.size,2);i.uniform2fv(this.addr,t)}function WS(i,e){let t=Ao(e,this.size,3);i.uniform3fv(this.addr,t)}function XS(i,e){let t=Ao(e,this.size,4);i.uniform4fv(this.addr,t)}function YS(i,e){let t=Ao(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function qS(i,e){let t=Ao(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function $S(i,e){let t=Ao(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function ZS(i,e){i.uniform1iv(this.addr,e)}function JS(i,e){i.uniform2iv(this.addr,e)}function KS(i,e){i.uniform3iv(this.addr,e)}function jS(i,e){i.uniform4iv(this.addr,e)}function QS(i,e){i.uniform1uiv(this.addr,e)}function ew(i,e){i.uniform2uiv(this.addr,e)}function tw(i,e){i.uniform3uiv(this.addr,e)}function nw(i,e){i.uniform4uiv(this.addr,e)}function iw(i,e,t){let n=this.cache,s=e.length,r=ph(t,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=mh(d0):o=u0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function sw(i,e,t){let n=this.cache,s=e.length,r=ph(t,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||m0,r[o])}function rw(i,e,t){let n=this.cache,s=e.length,r=ph(t,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=mh(f0):o=g0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function ow(i,e,t){let n=this.cache,s=e.length,r=ph(t,s);yn(n,r)||(i.uniform1iv(this.addr,r),vn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||p0,r[o])}function aw(i){switch(i){case 5126:return HS;case 35664:return VS;case 35665:return WS;case 35666:return XS;case 35674:return YS;case 35675:return qS;case 35676:return $S;case 5124:case 35670:return ZS;case 35667:case 35671:return JS;case 35668:case 35672:return KS;case 35669:case 35673:return jS;case 5125:return QS;case 36294:return ew;case 36295:return tw;case 36296:return nw;case 35678:case 36198:case 36298:case 36306:case 35682:return iw;case 35679:case 36299:case 36307:return sw;case 35680:case 36300:case 36308:case 36293:return rw;case 36289:case 36303:case 36311:case 36292:return ow}}var zd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=GS(t.type)}},kd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=aw(t.type)}},Gd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Fd=/(\w+)(\])?(\[|\.)?/g;function Zg(i,e){i.seq.push(e),i.map[e.id]=e}function lw(i,e,t){let n=i.name,s=n.length;for(Fd.lastIndex=0;;){let r=Fd.exec(n),o=Fd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Zg(t,c===void 0?new zd(a,i,e):new kd(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Gd(a),Zg(t,u)),t=u}}}var To=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);lw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Jg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var cw=37297,hw=0;function uw(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Kg=new at;function dw(i){Tt._getMatrix(Kg,Tt.workingColorSpace,i);let e=`mat3( ${Kg.elements.map(t=>t.toFixed(4))} )`;switch(Tt.getTransfer(i)){case ia:return[e,"LinearTransferOETF"];case Nt:return[e,"sRGBTransferOETF"];default:return rt("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function jg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+uw(i.getShaderSource(e),a)}else return r}function fw(i,e){let t=dw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var pw={[cd]:"Linear",[hd]:"Reinhard",[ud]:"Cineon",[dd]:"ACESFilmic",[pd]:"AgX",[md]:"Neutral",[fd]:"Custom"};function mw(i,e){let t=pw[e];return t===void 0?(rt("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var dh=new F;function gw(){Tt.getLuminanceCoefficients(dh);let i=dh.x.toFixed(4),e=dh.y.toFixed(4),t=dh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function _w(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ia).join(`
`)}function xw(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function yw(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Ia(i){return i!==""}function Qg(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function e0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var vw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Hd(i){return i.replace(vw,bw)}function bw(i,e){let t=_t[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Hd(t)}var Mw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function t0(i){return i.replace(Mw,Sw)}function Sw(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function n0(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var ww={[Ma]:"SHADOWMAP_TYPE_PCF",[bo]:"SHADOWMAP_TYPE_VSM"};function Tw(i){return ww[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Aw={[So]:"ENVMAP_MODE_REFRACTION"};function Ew(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Aw[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Cw={[Mc]:"ENVMAP_BLENDING_MULTIPLY",[vg]:"ENVMAP_BLENDING_MIX",[bg]:"ENVMAP_BLENDING_ADD"};function Rw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Cw[i.combine]||"ENVMAP_BLENDING_NONE"}function Pw(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=Tw(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Ew(t),u=Rw(t),d=_w(t),f=xw(r),g=s.createProgram(),b,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ia).join(`
`),b.length>0&&(b+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ia).join(`
`),p.length>0&&(p+=`
`)):(b=[n0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ia).join(`
`),p=[n0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Zi?"#define TONE_MAPPING":"",t.toneMapping!==Zi?_t.tonemapping_pars_fragment:"",t.toneMapping!==Zi?mw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",_t.colorspace_pars_fragment,fw("linearToOutputTexel",t.outputColorSpace),gw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ia).join(`
`)),o=Hd(o),o=Qg(o,t),o=e0(o,t),a=Hd(a),a=Qg(a,t),a=e0(a,t),o=t0(o),a=t0(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,b=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,p=["#define varying in",t.glslVersion===Cd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Cd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=m+b+o,C=m+p+a,M=Jg(s,s.VERTEX_SHADER,v),R=Jg(s,s.FRAGMENT_SHADER,C);s.attachShader(g,M),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(U){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(g)||"",G=s.getShaderInfoLog(M)||"",X=s.getShaderInfoLog(R)||"",D=L.trim(),V=G.trim(),Y=X.trim(),H=!0,ce=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,M,R);else{let q=jg(s,M,"vertex"),j=jg(s,R,"fragment");ht("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+D+`
`+q+`
`+j)}else D!==""?rt("WebGLProgram: Program Info Log:",D):(V===""||Y==="")&&(ce=!1);ce&&(U.diagnostics={runnable:H,programLog:D,vertexShader:{log:V,prefix:b},fragmentShader:{log:Y,prefix:p}})}s.deleteShader(M),s.deleteShader(R),y=new To(s,g),A=yw(s,g)}let y;this.getUniforms=function(){return y===void 0&&E(this),y};let A;this.getAttributes=function(){return A===void 0&&E(this),A};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(g,cw)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=hw++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=M,this.fragmentShader=R,this}var Iw=0,Vd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Wd(e),t.set(e,n)),n}},Wd=class{constructor(e){this.id=Iw++,this.code=e,this.usedTimes=0}};function Lw(i){return i===Ws||i===Ca||i===Ra}function Dw(i,e,t,n,s,r){let o=new ho,a=new Vd,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function g(y,A,k,U,L,G){let X=U.fog,D=L.geometry,V=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?U.environment:null,Y=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=e.get(y.envMap||V,Y),ce=d[y.type],q=n.precision;y.precision!==null&&(q=n.getMaxPrecision(y.precision),q!==y.precision&&rt("WebGLProgram.getParameters:",y.precision,"not supported, using",q,"instead."));let j=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ie=j!==void 0?j.length:0,pe=0;D.morphAttributes.position!==void 0&&(pe=1),D.morphAttributes.normal!==void 0&&(pe=2),D.morphAttributes.color!==void 0&&(pe=3);let he,ee,ge,Me;if(ce){let Ce=Ki[ce];he=Ce.vertexShader,ee=Ce.fragmentShader}else{he=y.vertexShader,ee=y.fragmentShader;let Ce=a.getVertexShaderStage(y),lt=a.getFragmentShaderStage(y);a.update(y,Ce,lt),ge=Ce.id,Me=lt.id}let Le=i.getRenderTarget(),Ee=i.state.buffers.depth.getReversed(),je=L.isInstancedMesh===!0,ut=L.isBatchedMesh===!0,Je=!!y.map,ft=!!y.matcap,pt=!!H,ot=pt&&H.isPMREMTexture===!0,Ut=!!y.aoMap,Lt=!!y.lightMap,Wt=!!y.bumpMap&&y.wireframe===!1,K=!!y.normalMap,de=!!y.displacementMap,xe=!!y.emissiveMap,Se=!!y.metalnessMap,_e=!!y.roughnessMap,$e=y.anisotropy>0,P=y.clearcoat>0,ue=y.diffuseRoughness>0,ke=y.dispersion>0,Ue=y.retroreflectivity>0,ye=y.iridescence>0,Xe=y.sheen>0,Te=y.transmission>0,Ge=$e&&!!y.anisotropyMap,T=P&&!!y.clearcoatMap,x=P&&!!y.clearcoatNormalMap,B=P&&!!y.clearcoatRoughnessMap,se=ue&&!!y.diffuseRoughnessMap,Q=ye&&!!y.iridescenceMap,me=ye&&!!y.iridescenceThicknessMap,ve=Xe&&!!y.sheenColorMap,te=Xe&&!!y.sheenRoughnessMap,re=!!y.specularMap,be=!!y.specularColorMap,O=!!y.specularIntensityMap,ae=Te&&!!y.transmissionMap,oe=Te&&!!y.thicknessMap,Pe=!!y.gradientMap,Ae=!!y.alphaMap,Re=y.alphaTest>0,Qe=!!y.alphaHash,st=!!y.extensions,le=Zi;y.toneMapped&&(Le===null||Le.isXRRenderTarget===!0)&&(le=i.toneMapping);let Fe=ot?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,tt={shaderID:ce,shaderType:y.type,shaderName:y.name,vertexShader:he,fragmentShader:ee,defines:y.defines,customVertexShaderID:ge,customFragmentShaderID:Me,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:q,batching:ut,batchingColor:ut&&L._colorsTexture!==null,instancing:je,instancingColor:je&&L.instanceColor!==null,instancingMorph:je&&L.morphTexture!==null,outputColorSpace:Le===null?i.outputColorSpace:Le.isXRRenderTarget===!0?Le.texture.colorSpace:Tt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Je,matcap:ft,envMap:pt,envMapMode:pt&&H.mapping,envMapPMREM:ot,envMapMaxLod:ot?Fe.length-1:null,envMapSize:ot?Fe[0].width:null,aoMap:Ut,lightMap:Lt,bumpMap:Wt,normalMap:K,displacementMap:de,emissiveMap:xe,normalMapObjectSpace:K&&y.normalMapType===wg,normalMapTangentSpace:K&&y.normalMapType===lh,packedNormalMap:K&&y.normalMapType===lh&&Lw(y.normalMap.format),metalnessMap:Se,roughnessMap:_e,anisotropy:$e,anisotropyMap:Ge,clearcoat:P,clearcoatMap:T,clearcoatNormalMap:x,clearcoatRoughnessMap:B,diffuseRoughness:ue,diffuseRoughnessMap:se,dispersion:ke,retroreflection:Ue,iridescence:ye,iridescenceMap:Q,iridescenceThicknessMap:me,sheen:Xe,sheenColorMap:ve,sheenRoughnessMap:te,specularMap:re,specularColorMap:be,specularIntensityMap:O,transmission:Te,transmissionMap:ae,thicknessMap:oe,gradientMap:Pe,opaque:y.transparent===!1&&y.blending===Mo&&y.alphaToCoverage===!1,alphaMap:Ae,alphaTest:Re,alphaHash:Qe,combine:y.combine,mapUv:Je&&f(y.map.channel),aoMapUv:Ut&&f(y.aoMap.channel),lightMapUv:Lt&&f(y.lightMap.channel),bumpMapUv:Wt&&f(y.bumpMap.channel),normalMapUv:K&&f(y.normalMap.channel),displacementMapUv:de&&f(y.displacementMap.channel),emissiveMapUv:xe&&f(y.emissiveMap.channel),metalnessMapUv:Se&&f(y.metalnessMap.channel),roughnessMapUv:_e&&f(y.roughnessMap.channel),anisotropyMapUv:Ge&&f(y.anisotropyMap.channel),clearcoatMapUv:T&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:x&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:B&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:se&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:me&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(y.sheenRoughnessMap.channel),specularMapUv:re&&f(y.specularMap.channel),specularColorMapUv:be&&f(y.specularColorMap.channel),specularIntensityMapUv:O&&f(y.specularIntensityMap.channel),transmissionMapUv:ae&&f(y.transmissionMap.channel),thicknessMapUv:oe&&f(y.thicknessMap.channel),alphaMapUv:Ae&&f(y.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(K||$e),vertexNormals:!!D.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!D.attributes.uv&&(Je||Ae),fog:!!X,useFog:y.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||D.attributes.normal===void 0&&K===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Ee,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:pe,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:G.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:le,decodeVideoTexture:Je&&y.map.isVideoTexture===!0&&Tt.getTransfer(y.map.colorSpace)===Nt,decodeVideoTextureEmissive:xe&&y.emissiveMap.isVideoTexture===!0&&Tt.getTransfer(y.emissiveMap.colorSpace)===Nt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Zn,flipSided:y.side===$n,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:st&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(st&&y.extensions.multiDraw===!0||ut)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function b(y){let A=[];if(y.shaderID?A.push(y.shaderID):(A.push(y.customVertexShaderID),A.push(y.customFragmentShaderID)),y.defines!==void 0)for(let k in y.defines)A.push(k),A.push(y.defines[k]);return y.isRawShaderMaterial===!1&&(p(A,y),m(A,y),A.push(i.outputColorSpace)),A.push(y.customProgramCacheKey),A.join()}function p(y,A){y.push(A.precision),y.push(A.outputColorSpace),y.push(A.envMapMode),y.push(A.envMapPMREM),y.push(A.envMapMaxLod),y.push(A.envMapSize),y.push(A.mapUv),y.push(A.alphaMapUv),y.push(A.lightMapUv),y.push(A.aoMapUv),y.push(A.bumpMapUv),y.push(A.normalMapUv),y.push(A.displacementMapUv),y.push(A.emissiveMapUv),y.push(A.metalnessMapUv),y.push(A.roughnessMapUv),y.push(A.anisotropyMapUv),y.push(A.clearcoatMapUv),y.push(A.clearcoatNormalMapUv),y.push(A.clearcoatRoughnessMapUv),y.push(A.diffuseRoughnessMapUv),y.push(A.iridescenceMapUv),y.push(A.iridescenceThicknessMapUv),y.push(A.sheenColorMapUv),y.push(A.sheenRoughnessMapUv),y.push(A.specularMapUv),y.push(A.specularColorMapUv),y.push(A.specularIntensityMapUv),y.push(A.transmissionMapUv),y.push(A.thicknessMapUv),y.push(A.combine),y.push(A.fogExp2),y.push(A.sizeAttenuation),y.push(A.morphTargetsCount),y.push(A.numSunLights),y.push(A.numDirLights),y.push(A.numPointLights),y.push(A.numSpotLights),y.push(A.numSpotLightMaps),y.push(A.numHemiLights),y.push(A.numRectAreaLights),y.push(A.numSunLightShadows),y.push(A.numDirLightShadows),y.push(A.numPointLightShadows),y.push(A.numSpotLightShadows),y.push(A.numSpotLightShadowsWithMaps),y.push(A.numLightProbes),y.push(A.numLightProbeGrids),y.push(A.shadowMapType),y.push(A.toneMapping),y.push(A.numClippingPlanes),y.push(A.numClipIntersection),y.push(A.depthPacking)}function m(y,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function v(y){let A=d[y.type],k;if(A){let U=Ki[A];k=Fg.clone(U.uniforms)}else k=y.uniforms;return k}function C(y,A){let k=h.get(A);return k!==void 0?++k.usedTimes:(k=new Pw(i,A,y,s),c.push(k),h.set(A,k)),k}function M(y){if(--y.usedTimes===0){let A=c.indexOf(y);c[A]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function R(y){a.remove(y)}function E(){a.dispose()}return{getParameters:g,getProgramCacheKey:b,getUniforms:v,acquireProgram:C,releaseProgram:M,releaseShaderCache:R,programs:c,dispose:E}}function Nw(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function Uw(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function i0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function s0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,b,p,m){let v=i[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:b,renderOrder:d.renderOrder,z:p,group:m},i[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=g,v.materialVariant=o(d),v.groupOrder=b,v.renderOrder=d.renderOrder,v.z=p,v.group=m),e++,v}function l(d,f,g,b,p,m,v){v.reversedDepth===!0&&(p=-p);let C=a(d,f,g,b,p,m);g.transmission>0?n.push(C):g.transparent===!0?s.push(C):t.push(C)}function c(d,f,g,b,p,m){let v=a(d,f,g,b,p,m);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function h(d,f){t.length>1&&t.sort(d||Uw),n.length>1&&n.sort(f||i0),s.length>1&&s.sort(f||i0)}function u(){for(let d=e,f=i.length;d<f;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Ow(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new s0,i.set(n,[o])):s>=r.length?(o=new s0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function Fw(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new F,color:new nt};break;case"SpotLight":t={position:new F,direction:new F,color:new nt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new F,color:new nt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new F,skyColor:new nt,groundColor:new nt};break;case"RectAreaLight":t={color:new nt,position:new F,halfWidth:new F,halfHeight:new F};break}return i[e.id]=t,t}}}function Bw(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var zw=0;function kw(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function Gw(i){let e=new Fw,t=Bw(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new F);let s=new F,r=new bt,o=new bt;function a(c){let h=0,u=0,d=0;for(let G=0;G<9;G++)n.probe[G].set(0,0,0);let f=0,g=0,b=0,p=0,m=0,v=0,C=0,M=0,R=0,E=0,y=0,A=0,k=0,U=0;c.sort(kw);for(let G=0,X=c.length;G<X;G++){let D=c[G],V=D.color,Y=D.intensity,H=D.distance,ce=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Ws?ce=D.shadow.map.texture:ce=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=V.r*Y,u+=V.g*Y,d+=V.b*Y;else if(D.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(D.sh.coefficients[q],Y);U++}else if(D.isSunLight){let q=e.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let j=D.shadow,ie=t.get(D);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[g]=ie,n.sunShadowMap[g]=ce;let pe=j.getViewportCount();for(let he=0;he<pe;he++)n.sunShadowMatrix[b+he]=j.getMatrix(he),n.sunShadowCascade[b+he]=j._cascadeData[he];b+=pe,g++}n.sun[f]=q,f++}else if(D.isDirectionalLight){let q=e.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let j=D.shadow,ie=t.get(D);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,n.directionalShadow[p]=ie,n.directionalShadowMap[p]=ce,n.directionalShadowMatrix[p]=D.shadow.matrix,R++}n.directional[p]=q,p++}else if(D.isSpotLight){let q=e.get(D);q.position.setFromMatrixPosition(D.matrixWorld),q.color.copy(V).multiplyScalar(Y),q.distance=H,q.coneCos=Math.cos(D.angle),q.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),q.decay=D.decay,n.spot[v]=q;let j=D.shadow;if(D.map&&(n.spotLightMap[A]=D.map,A++,j.updateMatrices(D),D.castShadow&&k++),n.spotLightMatrix[v]=j.matrix,D.castShadow){let ie=t.get(D);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,n.spotShadow[v]=ie,n.spotShadowMap[v]=ce,y++}v++}else if(D.isRectAreaLight){let q=e.get(D);q.color.copy(V).multiplyScalar(Y),q.halfWidth.set(D.width*.5,0,0),q.halfHeight.set(0,D.height*.5,0),n.rectArea[C]=q,C++}else if(D.isPointLight){let q=e.get(D);if(q.color.copy(D.color).multiplyScalar(D.intensity),q.distance=D.distance,q.decay=D.decay,D.castShadow){let j=D.shadow,ie=t.get(D);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,ie.shadowCameraNear=j.camera.near,ie.shadowCameraFar=j.camera.far,n.pointShadow[m]=ie,n.pointShadowMap[m]=ce,n.pointShadowMatrix[m]=D.shadow.matrix,E++}n.point[m]=q,m++}else if(D.isHemisphereLight){let q=e.get(D);q.skyColor.copy(D.color).multiplyScalar(Y),q.groundColor.copy(D.groundColor).multiplyScalar(Y),n.hemi[M]=q,M++}}C>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ze.LTC_FLOAT_1,n.rectAreaLTC2=ze.LTC_FLOAT_2):(n.rectAreaLTC1=ze.LTC_HALF_1,n.rectAreaLTC2=ze.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let L=n.hash;(L.sunLength!==f||L.directionalLength!==p||L.pointLength!==m||L.spotLength!==v||L.rectAreaLength!==C||L.hemiLength!==M||L.numSunShadows!==g||L.numDirectionalShadows!==R||L.numPointShadows!==E||L.numSpotShadows!==y||L.numSpotMaps!==A||L.numLightProbes!==U)&&(n.sun.length=f,n.directional.length=p,n.spot.length=v,n.rectArea.length=C,n.point.length=m,n.hemi.length=M,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=b,n.sunShadowCascade.length=b,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+A-k,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=U,L.sunLength=f,L.directionalLength=p,L.pointLength=m,L.spotLength=v,L.rectAreaLength=C,L.hemiLength=M,L.numSunShadows=g,L.numDirectionalShadows=R,L.numPointShadows=E,L.numSpotShadows=y,L.numSpotMaps=A,L.numLightProbes=U,n.version=zw++)}function l(c,h){let u=0,d=0,f=0,g=0,b=0,p=0,m=h.matrixWorldInverse;for(let v=0,C=c.length;v<C;v++){let M=c[v];if(M.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(m),u++}else if(M.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),d++}else if(M.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),g++}else if(M.isRectAreaLight){let R=n.rectArea[b];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(M.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(M.width*.5,0,0),R.halfHeight.set(0,M.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),b++}else if(M.isPointLight){let R=n.point[f];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(m),f++}else if(M.isHemisphereLight){let R=n.hemi[p];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:n}}function r0(i){let e=new Gw(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function Hw(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new r0(i),e.set(s,[a])):r>=o.length?(a=new r0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var Vw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Ww=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Xw=[new F(1,0,0),new F(-1,0,0),new F(0,1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1)],Yw=[new F(0,-1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1),new F(0,-1,0),new F(0,-1,0)],o0=new bt,Pa=new F,Bd=new F;function qw(i,e,t){let n=new Yi,s=new qe,r=new qe,o=new Ct,a=new lc,l=new cc,c={},h=t.maxTextureSize,u={[Vs]:$n,[$n]:Vs,[Zn]:Zn},d=new $i({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new qe},radius:{value:4}},vertexShader:Vw,fragmentShader:Ww}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new on;g.setAttribute("position",new En(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new an(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ma;let m=this.type;this.render=function(E,y,A){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===tg&&(rt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ma);let k=i.getRenderTarget(),U=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),G=i.state;G.setBlending(hr),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let X=m!==this.type;X&&y.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(V=>V.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,V=E.length;D<V;D++){let Y=E[D],H=Y.shadow;if(H===void 0){rt("WebGLShadowMap:",Y,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ce=H.getFrameExtents();s.multiply(ce),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ce.x),s.x=r.x*ce.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ce.y),s.y=r.y*ce.y,H.mapSize.y=r.y));let q=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=q,H.map===null||X===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===bo){if(Y.isPointLight){rt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new ci(s.x,s.y,{format:Ws,type:Li,minFilter:Yn,magFilter:Yn,generateMipmaps:!1}),H.map.texture.name=Y.name+".shadowMap",H.map.depthTexture=new ms(s.x,s.y,Ii),H.map.depthTexture.name=Y.name+".shadowMapDepth",H.map.depthTexture.format=ds,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Cn,H.map.depthTexture.magFilter=Cn}else Y.isPointLight?(H.map=new La(s.x),H.map.depthTexture=new da(s.x,Pi)):(H.map=new ci(s.x,s.y),H.map.depthTexture=new ms(s.x,s.y,Pi)),H.map.depthTexture.name=Y.name+".shadowMap",H.map.depthTexture.format=ds,this.type===Ma?(H.map.depthTexture.compareFunction=q?Td:wd,H.map.depthTexture.minFilter=Yn,H.map.depthTexture.magFilter=Yn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Cn,H.map.depthTexture.magFilter=Cn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let j=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();Y.isPointLight!==!0&&H.updateMatrices(Y,A);let ie=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:A.layers;for(let pe=0;pe<j;pe++){let he=H.getCamera(pe);if(Y.isPointLight){let ee=H.camera,ge=H.matrix,Me=Y.distance||ee.far;Me!==ee.far&&(ee.far=Me,ee.updateProjectionMatrix()),Pa.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(Pa),Bd.copy(ee.position),Bd.add(Xw[pe]),ee.up.copy(Yw[pe]),ee.lookAt(Bd),ee.updateMatrixWorld(),ge.makeTranslation(-Pa.x,-Pa.y,-Pa.z),o0.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),H._frustum.setFromProjectionMatrix(o0,ee.coordinateSystem,ee.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,pe),i.clear();else{pe===0&&(i.setRenderTarget(H.map),i.clear());let ee=H.getViewport(pe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),G.viewport(o)}n=H.getFrustum(pe),M(y,A,he,Y,ie,this.type)}H.isPointLightShadow!==!0&&this.type===bo&&v(H,A),H.needsUpdate=!1}m=this.type,p.needsUpdate=!1,i.setRenderTarget(k,U,L)};function v(E,y){let A=e.update(b);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new ci(s.x,s.y,{format:Ws,type:Li}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(y,null,A,d,b,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(y,null,A,f,b,null)}function C(E,y,A,k){let U=null,L=A.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(L!==void 0)U=L;else if(U=A.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let G=U.uuid,X=y.uuid,D=c[G];D===void 0&&(D={},c[G]=D);let V=D[X];V===void 0&&(V=U.clone(),D[X]=V,y.addEventListener("dispose",R)),U=V}if(U.visible=y.visible,U.wireframe=y.wireframe,k===bo?U.side=y.shadowSide!==null?y.shadowSide:y.side:U.side=y.shadowSide!==null?y.shadowSide:u[y.side],U.alphaMap=y.alphaMap,U.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,U.map=y.map,U.clipShadows=y.clipShadows,U.clippingPlanes=y.clippingPlanes,U.clipIntersection=y.clipIntersection,U.displacementMap=y.displacementMap,U.displacementScale=y.displacementScale,U.displacementBias=y.displacementBias,U.wireframeLinewidth=y.wireframeLinewidth,U.linewidth=y.linewidth,A.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let G=i.properties.get(U);G.light=A}return U}function M(E,y,A,k,U,L){if(E.visible===!1)return;if(E.layers.test(U)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&L===bo)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,E.matrixWorld);let D=e.update(E),V=E.material;if(Array.isArray(V)){let Y=D.groups;for(let H=0,ce=Y.length;H<ce;H++){let q=Y[H],j=V[q.materialIndex];if(j&&j.visible){let ie=C(E,j,k,L);E.onBeforeShadow(i,E,y,A,D,ie,q),i.renderBufferDirect(A,null,D,ie,E,q),E.onAfterShadow(i,E,y,A,D,ie,q)}}}else if(V.visible){let Y=C(E,V,k,L);E.onBeforeShadow(i,E,y,A,D,Y,null),i.renderBufferDirect(A,null,D,Y,E,null),E.onAfterShadow(i,E,y,A,D,Y,null)}}let X=E.children;for(let D=0,V=X.length;D<V;D++)M(X[D],y,A,k,U,L)}function R(E){E.target.removeEventListener("dispose",R);for(let A in c){let k=c[A],U=E.target.uuid;U in k&&(k[U].dispose(),delete k[U])}}}function $w(i,e){function t(){let O=!1,ae=new Ct,oe=null,Pe=new Ct(0,0,0,0);return{setMask:function(Ae){oe!==Ae&&!O&&(i.colorMask(Ae,Ae,Ae,Ae),oe=Ae)},setLocked:function(Ae){O=Ae},setClear:function(Ae,Re,Qe,st,le){le===!0&&(Ae*=st,Re*=st,Qe*=st),ae.set(Ae,Re,Qe,st),Pe.equals(ae)===!1&&(i.clearColor(Ae,Re,Qe,st),Pe.copy(ae))},reset:function(){O=!1,oe=null,Pe.set(-1,0,0,0)}}}function n(){let O=!1,ae=!1,oe=null,Pe=null,Ae=null;return{setReversed:function(Re){if(ae!==Re){let Qe=e.get("EXT_clip_control");Re?Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.ZERO_TO_ONE_EXT):Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.NEGATIVE_ONE_TO_ONE_EXT),ae=Re;let st=Ae;Ae=null,this.setClear(st)}},getReversed:function(){return ae},setTest:function(Re){Re?Ee(i.DEPTH_TEST):je(i.DEPTH_TEST)},setMask:function(Re){oe!==Re&&!O&&(i.depthMask(Re),oe=Re)},setFunc:function(Re){if(ae&&(Re=Ng[Re]),Pe!==Re){switch(Re){case Wl:i.depthFunc(i.NEVER);break;case Xl:i.depthFunc(i.ALWAYS);break;case Yl:i.depthFunc(i.LESS);break;case ro:i.depthFunc(i.LEQUAL);break;case ql:i.depthFunc(i.EQUAL);break;case $l:i.depthFunc(i.GEQUAL);break;case Zl:i.depthFunc(i.GREATER);break;case Jl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Pe=Re}},setLocked:function(Re){O=Re},setClear:function(Re){Ae!==Re&&(Ae=Re,ae&&(Re=1-Re),i.clearDepth(Re))},reset:function(){O=!1,oe=null,Pe=null,Ae=null,ae=!1}}}function s(){let O=!1,ae=null,oe=null,Pe=null,Ae=null,Re=null,Qe=null,st=null,le=null;return{setTest:function(Fe){O||(Fe?Ee(i.STENCIL_TEST):je(i.STENCIL_TEST))},setMask:function(Fe){ae!==Fe&&!O&&(i.stencilMask(Fe),ae=Fe)},setFunc:function(Fe,tt,Ce){(oe!==Fe||Pe!==tt||Ae!==Ce)&&(i.stencilFunc(Fe,tt,Ce),oe=Fe,Pe=tt,Ae=Ce)},setOp:function(Fe,tt,Ce){(Re!==Fe||Qe!==tt||st!==Ce)&&(i.stencilOp(Fe,tt,Ce),Re=Fe,Qe=tt,st=Ce)},setLocked:function(Fe){O=Fe},setClear:function(Fe){le!==Fe&&(i.clearStencil(Fe),le=Fe)},reset:function(){O=!1,ae=null,oe=null,Pe=null,Ae=null,Re=null,Qe=null,st=null,le=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],b=null,p=!1,m=null,v=null,C=null,M=null,R=null,E=null,y=null,A=new nt(0,0,0),k=0,U=!1,L=null,G=null,X=null,D=null,V=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ce=0,q=i.getParameter(i.VERSION);q.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(q)[1]),H=ce>=1):q.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),H=ce>=2);let j=null,ie={},pe=i.getParameter(i.SCISSOR_BOX),he=i.getParameter(i.VIEWPORT),ee=new Ct().fromArray(pe),ge=new Ct().fromArray(he);function Me(O,ae,oe,Pe){let Ae=new Uint8Array(4),Re=i.createTexture();i.bindTexture(O,Re),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Qe=0;Qe<oe;Qe++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(ae,0,i.RGBA,1,1,Pe,0,i.RGBA,i.UNSIGNED_BYTE,Ae):i.texImage2D(ae+Qe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Ae);return Re}let Le={};Le[i.TEXTURE_2D]=Me(i.TEXTURE_2D,i.TEXTURE_2D,1),Le[i.TEXTURE_CUBE_MAP]=Me(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Le[i.TEXTURE_2D_ARRAY]=Me(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Le[i.TEXTURE_3D]=Me(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Ee(i.DEPTH_TEST),o.setFunc(ro),Wt(!1),K(id),Ee(i.CULL_FACE),Ut(hr);function Ee(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function je(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function ut(O,ae){return d[O]!==ae?(i.bindFramebuffer(O,ae),d[O]=ae,O===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=ae),O===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=ae),!0):!1}function Je(O,ae){let oe=g,Pe=!1;if(O){oe=f.get(ae),oe===void 0&&(oe=[],f.set(ae,oe));let Ae=O.textures;if(oe.length!==Ae.length||oe[0]!==i.COLOR_ATTACHMENT0){for(let Re=0,Qe=Ae.length;Re<Qe;Re++)oe[Re]=i.COLOR_ATTACHMENT0+Re;oe.length=Ae.length,Pe=!0}}else oe[0]!==i.BACK&&(oe[0]=i.BACK,Pe=!0);Pe&&i.drawBuffers(oe)}function ft(O){return b!==O?(i.useProgram(O),b=O,!0):!1}let pt={[ur]:i.FUNC_ADD,[ig]:i.FUNC_SUBTRACT,[sg]:i.FUNC_REVERSE_SUBTRACT};pt[rg]=i.MIN,pt[og]=i.MAX;let ot={[ag]:i.ZERO,[lg]:i.ONE,[cg]:i.SRC_COLOR,[ad]:i.SRC_ALPHA,[mg]:i.SRC_ALPHA_SATURATE,[fg]:i.DST_COLOR,[ug]:i.DST_ALPHA,[hg]:i.ONE_MINUS_SRC_COLOR,[ld]:i.ONE_MINUS_SRC_ALPHA,[pg]:i.ONE_MINUS_DST_COLOR,[dg]:i.ONE_MINUS_DST_ALPHA,[gg]:i.CONSTANT_COLOR,[_g]:i.ONE_MINUS_CONSTANT_COLOR,[xg]:i.CONSTANT_ALPHA,[yg]:i.ONE_MINUS_CONSTANT_ALPHA};function Ut(O,ae,oe,Pe,Ae,Re,Qe,st,le,Fe){if(O===hr){p===!0&&(je(i.BLEND),p=!1);return}if(p===!1&&(Ee(i.BLEND),p=!0),O!==ng){if(O!==m||Fe!==U){if((v!==ur||R!==ur)&&(i.blendEquation(i.FUNC_ADD),v=ur,R=ur),Fe)switch(O){case Mo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case sd:i.blendFunc(i.ONE,i.ONE);break;case rd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case od:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ht("WebGLState: Invalid blending: ",O);break}else switch(O){case Mo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case sd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case rd:ht("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case od:ht("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ht("WebGLState: Invalid blending: ",O);break}C=null,M=null,E=null,y=null,A.set(0,0,0),k=0,m=O,U=Fe}return}Ae=Ae||ae,Re=Re||oe,Qe=Qe||Pe,(ae!==v||Ae!==R)&&(i.blendEquationSeparate(pt[ae],pt[Ae]),v=ae,R=Ae),(oe!==C||Pe!==M||Re!==E||Qe!==y)&&(i.blendFuncSeparate(ot[oe],ot[Pe],ot[Re],ot[Qe]),C=oe,M=Pe,E=Re,y=Qe),(st.equals(A)===!1||le!==k)&&(i.blendColor(st.r,st.g,st.b,le),A.copy(st),k=le),m=O,U=!1}function Lt(O,ae){O.side===Zn?je(i.CULL_FACE):Ee(i.CULL_FACE);let oe=O.side===$n;ae&&(oe=!oe),Wt(oe),O.blending===Mo&&O.transparent===!1?Ut(hr):Ut(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Pe=O.stencilWrite;a.setTest(Pe),Pe&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),xe(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?Ee(i.SAMPLE_ALPHA_TO_COVERAGE):je(i.SAMPLE_ALPHA_TO_COVERAGE)}function Wt(O){L!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),L=O)}function K(O){O!==Qm?(Ee(i.CULL_FACE),O!==G&&(O===id?i.cullFace(i.BACK):O===eg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):je(i.CULL_FACE),G=O}function de(O){O!==X&&(H&&i.lineWidth(O),X=O)}function xe(O,ae,oe){O?(Ee(i.POLYGON_OFFSET_FILL),(D!==ae||V!==oe)&&(D=ae,V=oe,o.getReversed()&&(ae=-ae,oe=-oe),i.polygonOffset(ae,oe))):je(i.POLYGON_OFFSET_FILL)}function Se(O){O?Ee(i.SCISSOR_TEST):je(i.SCISSOR_TEST)}function _e(O){O===void 0&&(O=i.TEXTURE0+Y-1),j!==O&&(i.activeTexture(O),j=O)}function $e(O,ae,oe){oe===void 0&&(j===null?oe=i.TEXTURE0+Y-1:oe=j);let Pe=ie[oe];Pe===void 0&&(Pe={type:void 0,texture:void 0},ie[oe]=Pe),(Pe.type!==O||Pe.texture!==ae)&&(j!==oe&&(i.activeTexture(oe),j=oe),i.bindTexture(O,ae||Le[O]),Pe.type=O,Pe.texture=ae)}function P(){let O=ie[j];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function ue(){try{i.compressedTexImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function ke(){try{i.compressedTexImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function Ue(){try{i.texSubImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function ye(){try{i.texSubImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function Xe(){try{i.compressedTexSubImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function Te(){try{i.compressedTexSubImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function Ge(){try{i.texStorage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function T(){try{i.texStorage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function x(){try{i.texImage2D(...arguments)}catch(O){ht("WebGLState:",O)}}function B(){try{i.texImage3D(...arguments)}catch(O){ht("WebGLState:",O)}}function se(O){return u[O]!==void 0?u[O]:i.getParameter(O)}function Q(O,ae){u[O]!==ae&&(i.pixelStorei(O,ae),u[O]=ae)}function me(O){ee.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function ve(O){ge.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),ge.copy(O))}function te(O,ae){let oe=c.get(ae);oe===void 0&&(oe=new WeakMap,c.set(ae,oe));let Pe=oe.get(O);Pe===void 0&&(Pe=i.getUniformBlockIndex(ae,O.name),i.uniformBlockBinding(ae,Pe,Pe),oe.set(O,Pe))}function re(O,ae,oe){let Ae=c.get(ae).get(O);l[Ae]!==oe&&(i.bindBufferBase(i.UNIFORM_BUFFER,Ae,oe),l[Ae]=oe)}function be(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},j=null,ie={},d={},l={},f=new WeakMap,g=[],b=null,p=!1,m=null,v=null,C=null,M=null,R=null,E=null,y=null,A=new nt(0,0,0),k=0,U=!1,L=null,G=null,X=null,D=null,V=null,ee.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Ee,disable:je,bindFramebuffer:ut,drawBuffers:Je,useProgram:ft,setBlending:Ut,setMaterial:Lt,setFlipSided:Wt,setCullFace:K,setLineWidth:de,setPolygonOffset:xe,setScissorTest:Se,activeTexture:_e,bindTexture:$e,unbindTexture:P,compressedTexImage2D:ue,compressedTexImage3D:ke,texImage2D:x,texImage3D:B,pixelStorei:Q,getParameter:se,updateUBOMapping:te,uniformBlockBinding:re,texStorage2D:Ge,texStorage3D:T,texSubImage2D:Ue,texSubImage3D:ye,compressedTexSubImage2D:Xe,compressedTexSubImage3D:Te,scissor:me,viewport:ve,reset:be}}function Zw(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new qe,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,b=new FinalizationRegistry(T=>g.delete(T)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(T,x){return p?new OffscreenCanvas(T,x):sa("canvas")}function v(T,x,B){let se=1,Q=Ge(T);if((Q.width>B||Q.height>B)&&(se=B/Math.max(Q.width,Q.height)),se<1)if(typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&T instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&T instanceof ImageBitmap||typeof VideoFrame<"u"&&T instanceof VideoFrame){let me=Math.floor(se*Q.width),ve=Math.floor(se*Q.height);d===void 0&&(d=m(me,ve));let te=x?m(me,ve):d;return te.width=me,te.height=ve,te.getContext("2d").drawImage(T,0,0,me,ve),rt("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+me+"x"+ve+")."),te}else return"data"in T&&rt("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),T;return T}function C(T){return T.generateMipmaps}function M(T){i.generateMipmap(T)}function R(T){return T.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:T.isWebGL3DRenderTarget?i.TEXTURE_3D:T.isWebGLArrayRenderTarget||T.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(T,x,B,se,Q,me=!1){if(T!==null){if(i[T]!==void 0)return i[T];rt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+T+"'")}let ve;se&&(ve=e.get("EXT_texture_norm16"),ve||rt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=x;if(x===i.RED&&(B===i.FLOAT&&(te=i.R32F),B===i.HALF_FLOAT&&(te=i.R16F),B===i.UNSIGNED_BYTE&&(te=i.R8),B===i.UNSIGNED_SHORT&&ve&&(te=ve.R16_EXT),B===i.SHORT&&ve&&(te=ve.R16_SNORM_EXT)),x===i.RED_INTEGER&&(B===i.UNSIGNED_BYTE&&(te=i.R8UI),B===i.UNSIGNED_SHORT&&(te=i.R16UI),B===i.UNSIGNED_INT&&(te=i.R32UI),B===i.BYTE&&(te=i.R8I),B===i.SHORT&&(te=i.R16I),B===i.INT&&(te=i.R32I)),x===i.RG&&(B===i.FLOAT&&(te=i.RG32F),B===i.HALF_FLOAT&&(te=i.RG16F),B===i.UNSIGNED_BYTE&&(te=i.RG8),B===i.UNSIGNED_SHORT&&ve&&(te=ve.RG16_EXT),B===i.SHORT&&ve&&(te=ve.RG16_SNORM_EXT)),x===i.RG_INTEGER&&(B===i.UNSIGNED_BYTE&&(te=i.RG8UI),B===i.UNSIGNED_SHORT&&(te=i.RG16UI),B===i.UNSIGNED_INT&&(te=i.RG32UI),B===i.BYTE&&(te=i.RG8I),B===i.SHORT&&(te=i.RG16I),B===i.INT&&(te=i.RG32I)),x===i.RGB_INTEGER&&(B===i.UNSIGNED_BYTE&&(te=i.RGB8UI),B===i.UNSIGNED_SHORT&&(te=i.RGB16UI),B===i.UNSIGNED_INT&&(te=i.RGB32UI),B===i.BYTE&&(te=i.RGB8I),B===i.SHORT&&(te=i.RGB16I),B===i.INT&&(te=i.RGB32I)),x===i.RGBA_INTEGER&&(B===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),B===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),B===i.UNSIGNED_INT&&(te=i.RGBA32UI),B===i.BYTE&&(te=i.RGBA8I),B===i.SHORT&&(te=i.RGBA16I),B===i.INT&&(te=i.RGBA32I)),x===i.RGB&&(B===i.UNSIGNED_SHORT&&ve&&(te=ve.RGB16_EXT),B===i.SHORT&&ve&&(te=ve.RGB16_SNORM_EXT),B===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),B===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),x===i.RGBA){let re=me?ia:Tt.getTransfer(Q);B===i.FLOAT&&(te=i.RGBA32F),B===i.HALF_FLOAT&&(te=i.RGBA16F),B===i.UNSIGNED_BYTE&&(te=re===Nt?i.SRGB8_ALPHA8:i.RGBA8),B===i.UNSIGNED_SHORT&&ve&&(te=ve.RGBA16_EXT),B===i.SHORT&&ve&&(te=ve.RGBA16_SNORM_EXT),B===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),B===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function y(T,x){let B;return T?x===null||x===Pi||x===fr?B=i.DEPTH24_STENCIL8:x===Ii?B=i.DEPTH32F_STENCIL8:x===wo&&(B=i.DEPTH24_STENCIL8,rt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===Pi||x===fr?B=i.DEPTH_COMPONENT24:x===Ii?B=i.DEPTH_COMPONENT32F:x===wo&&(B=i.DEPTH_COMPONENT16),B}function A(T,x){return C(T)===!0||T.isFramebufferTexture&&T.minFilter!==Cn&&T.minFilter!==Yn?Math.log2(Math.max(x.width,x.height))+1:T.mipmaps.length>0?T.mipmaps.length:T.isCompressedTexture&&Array.isArray(T.image)?x.mipmaps.length:1}function k(T){let x=new WeakRef(T);n.get(T).__ref=x,g.add(x),b.register(T,x,x)}function U(T){let x=n.get(T).__ref;x!==void 0&&(g.delete(x),b.unregister(x))}function L(T){X(T.target)}function G(T){D(T.target)}function X(T){T.removeEventListener("dispose",L),U(T),Y(T),T.isVideoTexture&&h.delete(T),T.isHTMLTexture&&u.delete(T)}function D(T){T.removeEventListener("dispose",G),U(T),ce(T)}function V(){for(let T of g){let x=T.deref();x!==void 0&&(x.isRenderTarget===!0?D(x):X(x))}g.clear(),u.clear()}function Y(T){let x=n.get(T);if(x.__webglInit===void 0)return;let B=T.source,se=f.get(B);if(se){let Q=se[x.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&H(T),Object.keys(se).length===0&&f.delete(B)}n.remove(T)}function H(T){let x=n.get(T);i.deleteTexture(x.__webglTexture);let B=T.source,se=f.get(B);delete se[x.__cacheKey],o.memory.textures--}function ce(T){let x=n.get(T);x.__depthDisposeCallback&&x.__depthDisposeCallback();let B=T.depthTexture;if(B&&B.renderTarget===T&&X(B),T.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(x.__webglFramebuffer[Q]))for(let me=0;me<x.__webglFramebuffer[Q].length;me++)i.deleteFramebuffer(x.__webglFramebuffer[Q][me]);else i.deleteFramebuffer(x.__webglFramebuffer[Q]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[Q])}else{if(Array.isArray(x.__webglFramebuffer))for(let Q=0;Q<x.__webglFramebuffer.length;Q++)i.deleteFramebuffer(x.__webglFramebuffer[Q]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let Q=0;Q<x.__webglColorRenderbuffer.length;Q++)x.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[Q]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let se=T.textures;for(let Q=0,me=se.length;Q<me;Q++){let ve=n.get(se[Q]);ve.__webglTexture&&(i.deleteTexture(ve.__webglTexture),o.memory.textures--),n.remove(se[Q])}n.remove(T)}let q=0;function j(){q=0}function ie(){return q}function pe(T){q=T}function he(){let T=q;return T>=s.maxTextures&&rt("WebGLTextures: Trying to use "+(T+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,T}function ee(T){let x=[];return x.push(T.wrapS),x.push(T.wrapT),x.push(T.wrapR||0),x.push(T.magFilter),x.push(T.minFilter),x.push(T.anisotropy),x.push(T.internalFormat),x.push(T.format),x.push(T.type),x.push(T.generateMipmaps),x.push(T.mipmapsAutoUpdate),x.push(T.premultiplyAlpha),x.push(T.flipY),x.push(T.unpackAlignment),x.push(T.colorSpace),x.join()}function ge(T,x){let B=n.get(T);if(T.isVideoTexture&&Xe(T),T.isRenderTargetTexture===!1&&T.isExternalTexture!==!0&&T.version>0&&B.__version!==T.version){let se=T.image;if(se===null)rt("WebGLRenderer: Texture marked for update but no image data found.");else if(se.complete===!1)rt("WebGLRenderer: Texture marked for update but image is incomplete");else{Lt(B,T,x);return}}else T.isExternalTexture&&(B.__webglTexture=T.sourceTexture?T.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,B.__webglTexture,i.TEXTURE0+x)}function Me(T,x){let B=n.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&B.__version!==T.version){Lt(B,T,x);return}else T.isExternalTexture&&(B.__webglTexture=T.sourceTexture?T.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,B.__webglTexture,i.TEXTURE0+x)}function Le(T,x){let B=n.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&B.__version!==T.version){Lt(B,T,x);return}t.bindTexture(i.TEXTURE_3D,B.__webglTexture,i.TEXTURE0+x)}function Ee(T,x){let B=n.get(T);if(T.version>0&&B.__version!==T.version){Wt(B,T,x);return}t.bindTexture(i.TEXTURE_CUBE_MAP,B.__webglTexture,i.TEXTURE0+x)}let je={[Kl]:i.REPEAT,[Wi]:i.CLAMP_TO_EDGE,[jl]:i.MIRRORED_REPEAT},ut={[Cn]:i.NEAREST,[Mg]:i.NEAREST_MIPMAP_NEAREST,[Sa]:i.NEAREST_MIPMAP_LINEAR,[Yn]:i.LINEAR,[Tc]:i.LINEAR_MIPMAP_NEAREST,[_s]:i.LINEAR_MIPMAP_LINEAR},Je={[Ag]:i.NEVER,[Ad]:i.ALWAYS,[Eg]:i.LESS,[wd]:i.LEQUAL,[Cg]:i.EQUAL,[Td]:i.GEQUAL,[Rg]:i.GREATER,[Pg]:i.NOTEQUAL};function ft(T,x){if(x.type===Ii&&e.has("OES_texture_float_linear")===!1&&(x.magFilter===Yn||x.magFilter===Tc||x.magFilter===Sa||x.magFilter===_s||x.minFilter===Yn||x.minFilter===Tc||x.minFilter===Sa||x.minFilter===_s)&&rt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(T,i.TEXTURE_WRAP_S,je[x.wrapS]),i.texParameteri(T,i.TEXTURE_WRAP_T,je[x.wrapT]),(T===i.TEXTURE_3D||T===i.TEXTURE_2D_ARRAY)&&i.texParameteri(T,i.TEXTURE_WRAP_R,je[x.wrapR]),i.texParameteri(T,i.TEXTURE_MAG_FILTER,ut[x.magFilter]),i.texParameteri(T,i.TEXTURE_MIN_FILTER,ut[x.minFilter]),x.compareFunction&&(i.texParameteri(T,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(T,i.TEXTURE_COMPARE_FUNC,Je[x.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===Cn||x.minFilter!==Sa&&x.minFilter!==_s||x.type===Ii&&e.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let B=e.get("EXT_texture_filter_anisotropic");i.texParameterf(T,B.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function pt(T,x){let B=!1;T.__webglInit===void 0&&(T.__webglInit=!0,x.addEventListener("dispose",L),k(x));let se=x.source,Q=f.get(se);Q===void 0&&(Q={},f.set(se,Q));let me=ee(x);if(me!==T.__cacheKey){Q[me]===void 0&&(Q[me]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,B=!0),Q[me].usedTimes++;let ve=Q[T.__cacheKey];ve!==void 0&&(Q[T.__cacheKey].usedTimes--,ve.usedTimes===0&&H(x)),T.__cacheKey=me,T.__webglTexture=Q[me].texture}return B}function ot(T,x,B){return Math.floor(Math.floor(T/B)/x)}function Ut(T,x,B,se){let me=T.updateRanges;if(me.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,B,se,x.data);else{me.sort((O,ae)=>O.start-ae.start);let ve=0;for(let O=1;O<me.length;O++){let ae=me[ve],oe=me[O],Pe=ae.start+ae.count,Ae=ot(oe.start,x.width,4),Re=ot(ae.start,x.width,4);oe.start<=Pe+1&&Ae===Re&&ot(oe.start+oe.count-1,x.width,4)===Ae?ae.count=Math.max(ae.count,oe.start+oe.count-ae.start):(++ve,me[ve]=oe)}me.length=ve+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),re=t.getParameter(i.UNPACK_SKIP_PIXELS),be=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let O=0,ae=me.length;O<ae;O++){let oe=me[O],Pe=Math.floor(oe.start/4),Ae=Math.ceil(oe.count/4),Re=Pe%x.width,Qe=Math.floor(Pe/x.width),st=Ae,le=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Re),t.pixelStorei(i.UNPACK_SKIP_ROWS,Qe),t.texSubImage2D(i.TEXTURE_2D,0,Re,Qe,st,le,B,se,x.data)}T.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,re),t.pixelStorei(i.UNPACK_SKIP_ROWS,be)}}function Lt(T,x,B){let se=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(se=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(se=i.TEXTURE_3D);let Q=pt(T,x),me=x.source;t.bindTexture(se,T.__webglTexture,i.TEXTURE0+B);let ve=n.get(me);if(me.version!==ve.__version||Q===!0){if(t.activeTexture(i.TEXTURE0+B),(typeof ImageBitmap<"u"&&x.image instanceof ImageBitmap)===!1){let le=Tt.getPrimaries(Tt.workingColorSpace),Fe=x.colorSpace===ys?null:Tt.getPrimaries(x.colorSpace),tt=x.colorSpace===ys||le===Fe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment);let re=v(x.image,!1,s.maxTextureSize);re=Te(x,re);let be=r.convert(x.format,x.colorSpace),O=r.convert(x.type),ae=E(x.internalFormat,be,O,x.normalized,x.colorSpace,x.isVideoTexture);ft(se,x);let oe,Pe=x.mipmaps,Ae=x.isVideoTexture!==!0,Re=ve.__version===void 0||Q===!0,Qe=me.dataReady,st=A(x,re);if(x.isDepthTexture)ae=y(x.format===xs,x.type),Re&&(Ae?t.texStorage2D(i.TEXTURE_2D,1,ae,re.width,re.height):t.texImage2D(i.TEXTURE_2D,0,ae,re.width,re.height,0,be,O,null));else if(x.isDataTexture)if(Pe.length>0){Ae&&Re&&t.texStorage2D(i.TEXTURE_2D,st,ae,Pe[0].width,Pe[0].height);for(let le=0,Fe=Pe.length;le<Fe;le++)oe=Pe[le],Ae?Qe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,oe.width,oe.height,be,O,oe.data):t.texImage2D(i.TEXTURE_2D,le,ae,oe.width,oe.height,0,be,O,oe.data);x.generateMipmaps=!1}else Ae?(Re&&t.texStorage2D(i.TEXTURE_2D,st,ae,re.width,re.height),Qe&&Ut(x,re,be,O)):t.texImage2D(i.TEXTURE_2D,0,ae,re.width,re.height,0,be,O,re.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){Ae&&Re&&t.texStorage3D(i.TEXTURE_2D_ARRAY,st,ae,Pe[0].width,Pe[0].height,re.depth);for(let le=0,Fe=Pe.length;le<Fe;le++)if(oe=Pe[le],x.format!==Di)if(be!==null)if(Ae){if(Qe)if(x.layerUpdates.size>0){let tt=Od(oe.width,oe.height,x.format,x.type);for(let Ce of x.layerUpdates){let lt=oe.data.subarray(Ce*tt/oe.data.BYTES_PER_ELEMENT,(Ce+1)*tt/oe.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,Ce,oe.width,oe.height,1,be,lt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,oe.width,oe.height,re.depth,be,oe.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,le,ae,oe.width,oe.height,re.depth,0,oe.data,0,0);else rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Ae?Qe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,oe.width,oe.height,re.depth,be,O,oe.data):t.texImage3D(i.TEXTURE_2D_ARRAY,le,ae,oe.width,oe.height,re.depth,0,be,O,oe.data);x.layerUpdates.size>0&&x.clearLayerUpdates()}else{Ae&&Re&&t.texStorage2D(i.TEXTURE_2D,st,ae,Pe[0].width,Pe[0].height);for(let le=0,Fe=Pe.length;le<Fe;le++)oe=Pe[le],x.format!==Di?be!==null?Ae?Qe&&t.compressedTexSubImage2D(i.TEXTURE_2D,le,0,0,oe.width,oe.height,be,oe.data):t.compressedTexImage2D(i.TEXTURE_2D,le,ae,oe.width,oe.height,0,oe.data):rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Ae?Qe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,oe.width,oe.height,be,O,oe.data):t.texImage2D(i.TEXTURE_2D,le,ae,oe.width,oe.height,0,be,O,oe.data)}else if(x.isDataArrayTexture)if(Ae){if(Re&&t.texStorage3D(i.TEXTURE_2D_ARRAY,st,ae,re.width,re.height,re.depth),Qe)if(x.layerUpdates.size>0){let le=Od(re.width,re.height,x.format,x.type);for(let Fe of x.layerUpdates){let tt=re.data.subarray(Fe*le/re.data.BYTES_PER_ELEMENT,(Fe+1)*le/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Fe,re.width,re.height,1,be,O,tt)}x.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,be,O,re.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ae,re.width,re.height,re.depth,0,be,O,re.data);else if(x.isData3DTexture)Ae?(Re&&t.texStorage3D(i.TEXTURE_3D,st,ae,re.width,re.height,re.depth),Qe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,be,O,re.data)):t.texImage3D(i.TEXTURE_3D,0,ae,re.width,re.height,re.depth,0,be,O,re.data);else if(x.isFramebufferTexture){if(Re)if(Ae)t.texStorage2D(i.TEXTURE_2D,st,ae,re.width,re.height);else{let le=re.width,Fe=re.height;for(let tt=0;tt<st;tt++)t.texImage2D(i.TEXTURE_2D,tt,ae,le,Fe,0,be,O,null),le>>=1,Fe>>=1}}else if(x.isHTMLTexture){if("texElementImage2D"in i){let le=i.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),re.parentNode!==le){le.appendChild(re),u.add(x),le.onpaint=Fe=>{let tt=Fe.changedElements;for(let Ce of u)tt.includes(Ce.image)&&(Ce.needsUpdate=!0)},le.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,re);else{let tt=i.RGBA,Ce=i.RGBA,lt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,tt,Ce,lt,re)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Pe.length>0){if(Ae&&Re){let le=Ge(Pe[0]);t.texStorage2D(i.TEXTURE_2D,st,ae,le.width,le.height)}for(let le=0,Fe=Pe.length;le<Fe;le++)oe=Pe[le],Ae?Qe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,be,O,oe):t.texImage2D(i.TEXTURE_2D,le,ae,be,O,oe);x.generateMipmaps=!1}else if(Ae){if(Re){let le=Ge(re);t.texStorage2D(i.TEXTURE_2D,st,ae,le.width,le.height)}Qe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,be,O,re)}else t.texImage2D(i.TEXTURE_2D,0,ae,be,O,re);C(x)&&x.mipmapsAutoUpdate===!0&&M(se),ve.__version=me.version,x.onUpdate&&x.onUpdate(x)}T.__version=x.version}function Wt(T,x,B){if(x.image.length!==6)return;let se=pt(T,x),Q=x.source;t.bindTexture(i.TEXTURE_CUBE_MAP,T.__webglTexture,i.TEXTURE0+B);let me=n.get(Q);if(Q.version!==me.__version||se===!0){t.activeTexture(i.TEXTURE0+B);let ve=Tt.getPrimaries(Tt.workingColorSpace),te=x.colorSpace===ys?null:Tt.getPrimaries(x.colorSpace),re=x.colorSpace===ys||ve===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let be=x.isCompressedTexture||x.image[0].isCompressedTexture,O=x.image[0]&&x.image[0].isDataTexture,ae=[];for(let Ce=0;Ce<6;Ce++)!be&&!O?ae[Ce]=v(x.image[Ce],!0,s.maxCubemapSize):ae[Ce]=O?x.image[Ce].image:x.image[Ce],ae[Ce]=Te(x,ae[Ce]);let oe=ae[0],Pe=r.convert(x.format,x.colorSpace),Ae=r.convert(x.type),Re=E(x.internalFormat,Pe,Ae,x.normalized,x.colorSpace),Qe=x.isVideoTexture!==!0,st=me.__version===void 0||se===!0,le=Q.dataReady,Fe=A(x,oe);ft(i.TEXTURE_CUBE_MAP,x);let tt;if(x.isDepthTexture){if(Re=y(x.format===xs,x.type),st)if(Qe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Re,oe.width,oe.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Re,oe.width,oe.height,0,Pe,Ae,null)}else if(be){Qe&&st&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Fe,Re,oe.width,oe.height);for(let Ce=0;Ce<6;Ce++){tt=ae[Ce].mipmaps;for(let lt=0;lt<tt.length;lt++){let zt=tt[lt];x.format!==Di?Pe!==null?Qe?le&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,zt.width,zt.height,Pe,zt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,Re,zt.width,zt.height,0,zt.data):rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,zt.width,zt.height,Pe,Ae,zt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,Re,zt.width,zt.height,0,Pe,Ae,zt.data)}}}else{if(tt=x.mipmaps,Qe&&st){tt.length>0&&Fe++;let Ce=Ge(ae[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Fe,Re,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(O){Qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,ae[Ce].width,ae[Ce].height,Pe,Ae,ae[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Re,ae[Ce].width,ae[Ce].height,0,Pe,Ae,ae[Ce].data);for(let lt=0;lt<tt.length;lt++){let In=tt[lt].image[Ce].image;Qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,In.width,In.height,Pe,Ae,In.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,Re,In.width,In.height,0,Pe,Ae,In.data)}}else{Qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Pe,Ae,ae[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Re,Pe,Ae,ae[Ce]);for(let lt=0;lt<tt.length;lt++){let zt=tt[lt];Qe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Pe,Ae,zt.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,Re,Pe,Ae,zt.image[Ce])}}}C(x)&&x.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),me.__version=Q.version,x.onUpdate&&x.onUpdate(x)}T.__version=x.version}function K(T,x,B,se,Q,me){let ve=r.convert(B.format,B.colorSpace),te=r.convert(B.type),re=E(B.internalFormat,ve,te,B.normalized,B.colorSpace),be=n.get(x),O=n.get(B);if(O.__renderTarget=x,!be.__hasExternalTextures){let ae=Math.max(1,x.width>>me),oe=Math.max(1,x.height>>me);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?t.texImage3D(Q,me,re,ae,oe,x.depth,0,ve,te,null):t.texImage2D(Q,me,re,ae,oe,0,ve,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,T),ye(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,se,Q,O.__webglTexture,0,Ue(x)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,se,Q,O.__webglTexture,me),t.bindFramebuffer(i.FRAMEBUFFER,null)}function de(T,x,B){if(i.bindRenderbuffer(i.RENDERBUFFER,T),x.depthBuffer){let se=x.depthTexture,Q=se&&se.isDepthTexture?se.type:null,me=y(x.stencilBuffer,Q),ve=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ye(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ue(x),me,x.width,x.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ue(x),me,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,me,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ve,i.RENDERBUFFER,T)}else{let se=x.textures;for(let Q=0;Q<se.length;Q++){let me=se[Q],ve=r.convert(me.format,me.colorSpace),te=r.convert(me.type),re=E(me.internalFormat,ve,te,me.normalized,me.colorSpace);ye(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ue(x),re,x.width,x.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ue(x),re,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,re,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(T,x,B){let se=x.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,T),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(x.depthTexture);Q.__renderTarget=x;let me=se?x.depthTexture.image[0]:x.depthTexture.image;(!Q.__webglTexture||me.width!==x.width||me.height!==x.height)&&(me.width=x.width,me.height=x.height,x.depthTexture.needsUpdate=!0),se?Ee(x.depthTexture,0):ge(x.depthTexture,0);let ve=Q.__webglTexture,te=Ue(x),re=se?i.TEXTURE_CUBE_MAP_POSITIVE_X+B:i.TEXTURE_2D,be=x.depthTexture.format===xs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(x.depthTexture.format===ds)ye(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,be,re,ve,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,be,re,ve,0);else if(x.depthTexture.format===xs)ye(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,be,re,ve,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,be,re,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Se(T){let x=n.get(T),B=T.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==T.depthTexture){let se=T.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),se){let Q=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,se.removeEventListener("dispose",Q)};se.addEventListener("dispose",Q),x.__depthDisposeCallback=Q}x.__boundDepthTexture=se}if(T.depthTexture&&!x.__autoAllocateDepthBuffer)if(B)for(let se=0;se<6;se++)xe(x.__webglFramebuffer[se],T,se);else T.texture.mipmaps.length>0?xe(x.__webglFramebuffer[0],T,0):xe(x.__webglFramebuffer,T,0);else if(B){x.__webglDepthbuffer=[];for(let se=0;se<6;se++)if(t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[se]),x.__webglDepthbuffer[se]===void 0)x.__webglDepthbuffer[se]=i.createRenderbuffer(),de(x.__webglDepthbuffer[se],T,!1);else{let Q=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,me=x.__webglDepthbuffer[se];i.bindRenderbuffer(i.RENDERBUFFER,me),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,me)}}else if(T.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),de(x.__webglDepthbuffer,T,!1);else{let Q=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,me=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,me),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,me)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function _e(T,x,B){let se=n.get(T);x!==void 0&&K(se.__webglFramebuffer,T,T.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),B!==void 0&&Se(T)}function $e(T){let x=T.texture,B=n.get(T),se=n.get(x);T.addEventListener("dispose",G),k(T);let Q=T.textures,me=T.isWebGLCubeRenderTarget===!0,ve=Q.length>1;if(ve||(se.__webglTexture===void 0&&(se.__webglTexture=i.createTexture()),se.__version=x.version,o.memory.textures++),me){B.__webglFramebuffer=[];for(let te=0;te<6;te++)if(x.mipmaps.length>0){B.__webglFramebuffer[te]=[];for(let re=0;re<x.mipmaps.length;re++)B.__webglFramebuffer[te][re]=i.createFramebuffer()}else B.__webglFramebuffer[te]=i.createFramebuffer()}else{if(x.mipmaps.length>0){B.__webglFramebuffer=[];for(let te=0;te<x.mipmaps.length;te++)B.__webglFramebuffer[te]=i.createFramebuffer()}else B.__webglFramebuffer=i.createFramebuffer();if(ve)for(let te=0,re=Q.length;te<re;te++){let be=n.get(Q[te]);be.__webglTexture===void 0&&(be.__webglTexture=i.createTexture(),o.memory.textures++)}if(T.samples>0&&ye(T)===!1){B.__webglMultisampledFramebuffer=i.createFramebuffer(),B.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,B.__webglMultisampledFramebuffer);for(let te=0;te<Q.length;te++){let re=Q[te];B.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,B.__webglColorRenderbuffer[te]);let be=r.convert(re.format,re.colorSpace),O=r.convert(re.type),ae=E(re.internalFormat,be,O,re.normalized,re.colorSpace,T.isXRRenderTarget===!0),oe=Ue(T);i.renderbufferStorageMultisample(i.RENDERBUFFER,oe,ae,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,B.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),T.depthBuffer&&(B.__webglDepthRenderbuffer=i.createRenderbuffer(),de(B.__webglDepthRenderbuffer,T,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(me){t.bindTexture(i.TEXTURE_CUBE_MAP,se.__webglTexture),ft(i.TEXTURE_CUBE_MAP,x);for(let te=0;te<6;te++)if(x.mipmaps.length>0)for(let re=0;re<x.mipmaps.length;re++)K(B.__webglFramebuffer[te][re],T,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,re);else K(B.__webglFramebuffer[te],T,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);C(x)?M(i.TEXTURE_CUBE_MAP):x.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,x.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let te=0,re=Q.length;te<re;te++){let be=Q[te],O=n.get(be),ae=i.TEXTURE_2D;(T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(ae=T.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ae,O.__webglTexture),ft(ae,be),K(B.__webglFramebuffer,T,be,i.COLOR_ATTACHMENT0+te,ae,0),C(be)&&M(ae)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(te=T.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,se.__webglTexture),ft(te,x),x.mipmaps.length>0)for(let re=0;re<x.mipmaps.length;re++)K(B.__webglFramebuffer[re],T,x,i.COLOR_ATTACHMENT0,te,re);else K(B.__webglFramebuffer,T,x,i.COLOR_ATTACHMENT0,te,0);C(x)?M(te):x.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,x.mipmaps.length-1),t.unbindTexture()}T.depthBuffer&&Se(T)}function P(T){let x=T.textures;for(let B=0,se=x.length;B<se;B++){let Q=x[B];if(C(Q)&&Q.mipmapsAutoUpdate===!0){let me=R(T),ve=n.get(Q).__webglTexture;t.bindTexture(me,ve),M(me),t.unbindTexture()}}}let ue=[];function ke(T){if(T.samples>0){if(ye(T)===!1){let x=T.textures,B=T.width,se=T.height,Q=i.COLOR_BUFFER_BIT,me=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=n.get(T),te=x.length>1;if(te)for(let be=0;be<x.length;be++)t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+be,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+be,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),T.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let be=0;be<x.length;be++){if(T.resolveDepthBuffer&&(T.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),T.stencilBuffer&&T.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ve.__webglColorRenderbuffer[be]);let O=n.get(x[be]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,O,0)}i.blitFramebuffer(0,0,B,se,0,0,B,se,Q,i.NEAREST),l===!0&&(ue.length=0,ue.push(i.COLOR_ATTACHMENT0+be),T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&ue.push(me),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ue))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let be=0;be<x.length;be++){t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+be,i.RENDERBUFFER,ve.__webglColorRenderbuffer[be]);let O=n.get(x[be]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+be,i.TEXTURE_2D,O,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&l){let x=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function Ue(T){return Math.min(s.maxSamples,T.samples)}function ye(T){let x=n.get(T);return T.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function Xe(T){let x=o.render.frame;h.get(T)!==x&&(h.set(T,x),T.update())}function Te(T,x){let B=T.colorSpace,se=T.format,Q=T.type;return T.isCompressedTexture===!0||T.isVideoTexture===!0||B!==na&&B!==ys&&(Tt.getTransfer(B)===Nt?(se!==Di||Q!==Kn)&&rt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ht("WebGLTextures: Unsupported texture color space:",B)),x}function Ge(T){return typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement?(c.width=T.naturalWidth||T.width,c.height=T.naturalHeight||T.height):typeof VideoFrame<"u"&&T instanceof VideoFrame?(c.width=T.displayWidth,c.height=T.displayHeight):(c.width=T.width,c.height=T.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=j,this.getTextureUnits=ie,this.setTextureUnits=pe,this.setTexture2D=ge,this.setTexture2DArray=Me,this.setTexture3D=Le,this.setTextureCube=Ee,this.rebindTextures=_e,this.setupRenderTarget=$e,this.updateRenderTargetMipmap=P,this.updateMultisampleRenderTarget=ke,this.setupDepthRenderbuffer=Se,this.setupFrameBufferTexture=K,this.useMultisampledRTT=ye,this.dispose=V}function Jw(i,e){function t(n,s=ys){let r,o=Tt.getTransfer(s);if(n===Kn)return i.UNSIGNED_BYTE;if(n===Ec)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Cc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===yd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===vd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===_d)return i.BYTE;if(n===xd)return i.SHORT;if(n===wo)return i.UNSIGNED_SHORT;if(n===Ac)return i.INT;if(n===Pi)return i.UNSIGNED_INT;if(n===Ii)return i.FLOAT;if(n===Li)return i.HALF_FLOAT;if(n===bd)return i.ALPHA;if(n===Md)return i.RGB;if(n===Di)return i.RGBA;if(n===ds)return i.DEPTH_COMPONENT;if(n===xs)return i.DEPTH_STENCIL;if(n===Sd)return i.RED;if(n===Rc)return i.RED_INTEGER;if(n===Ws)return i.RG;if(n===Pc)return i.RG_INTEGER;if(n===Ic)return i.RGBA_INTEGER;if(n===wa||n===Ta||n===Aa||n===Ea)if(o===Nt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===wa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ta)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ea)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===wa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ta)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Aa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ea)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Lc||n===Dc||n===Nc||n===Uc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Lc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Dc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Nc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Uc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Oc||n===Fc||n===Bc||n===zc||n===kc||n===Ca||n===Gc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Oc||n===Fc)return o===Nt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Bc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===zc)return r.COMPRESSED_R11_EAC;if(n===kc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ca)return r.COMPRESSED_RG11_EAC;if(n===Gc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Hc||n===Vc||n===Wc||n===Xc||n===Yc||n===qc||n===$c||n===Zc||n===Jc||n===Kc||n===jc||n===Qc||n===eh||n===th)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Hc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Vc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Wc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Xc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Yc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===qc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===$c)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Zc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Jc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Kc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===jc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Qc)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===eh)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===th)return o===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===nh||n===ih||n===sh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===nh)return o===Nt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===ih)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===sh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===rh||n===oh||n===Ra||n===ah)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===rh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===oh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ra)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===ah)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===fr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var Kw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,jw=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Xd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new fa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new $i({vertexShader:Kw,fragmentShader:jw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new an(new lr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Yd=class extends Ei{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,g=null,b=typeof XRWebGLBinding<"u",p=new Xd,m={},v=t.getContextAttributes(),C=null,M=null,R=[],E=[],y=new qe,A=null,k=null,U=new Xn;U.viewport=new Ct;let L=new Xn;L.viewport=new Ct;let G=[U,L],X=new bc,D=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ge=R[ee];return ge===void 0&&(ge=new uo,R[ee]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(ee){let ge=R[ee];return ge===void 0&&(ge=new uo,R[ee]=ge),ge.getGripSpace()},this.getHand=function(ee){let ge=R[ee];return ge===void 0&&(ge=new uo,R[ee]=ge),ge.getHandSpace()};function Y(ee){let ge=E.indexOf(ee.inputSource);if(ge===-1)return;let Me=R[ge];Me!==void 0&&(Me.update(ee.inputSource,ee.frame,c||o),Me.dispatchEvent({type:ee.type,data:ee.inputSource}))}function H(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ce);for(let ee=0;ee<R.length;ee++){let ge=E[ee];ge!==null&&(E[ee]=null,R[ee].disconnect(ge))}D=null,V=null,p.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(C),f=null,d=null,u=null,s=null,M=null,he.stop(),n.isPresenting=!1,e.setPixelRatio(A),e.setSize(y.width,y.height,!1),k!==null){let ee=k.camera;ee.fov=k.fov,ee.zoom=k.zoom,ee.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&rt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&rt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&b&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ce),v.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(y),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let Me=null,Le=null,Ee=null;v.depth&&(Ee=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Me=v.stencil?xs:ds,Le=v.stencil?fr:Pi);let je={colorFormat:t.RGBA8,depthFormat:Ee,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(je),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new ci(d.textureWidth,d.textureHeight,{format:Di,type:Kn,depthTexture:new ms(d.textureWidth,d.textureHeight,Le,void 0,void 0,void 0,void 0,void 0,void 0,Me),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Me={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,Me),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new ci(f.framebufferWidth,f.framebufferHeight,{format:Di,type:Kn,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ce(ee){for(let ge=0;ge<ee.removed.length;ge++){let Me=ee.removed[ge],Le=E.indexOf(Me);Le>=0&&(E[Le]=null,R[Le].disconnect(Me))}for(let ge=0;ge<ee.added.length;ge++){let Me=ee.added[ge],Le=E.indexOf(Me);if(Le===-1){for(let je=0;je<R.length;je++)if(je>=E.length){E.push(Me),Le=je;break}else if(E[je]===null){E[je]=Me,Le=je;break}if(Le===-1)break}let Ee=R[Le];Ee&&Ee.connect(Me)}}function q(ee,ge){ge===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ge.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ge=ee.near,Me=ee.far;p.texture!==null&&(p.depthNear>0&&(ge=p.depthNear),p.depthFar>0&&(Me=p.depthFar)),X.near=L.near=U.near=ge,X.far=L.far=U.far=Me,(D!==X.near||V!==X.far)&&(s.updateRenderState({depthNear:X.near,depthFar:X.far}),D=X.near,V=X.far),X.layers.mask=ee.layers.mask|6,U.layers.mask=X.layers.mask&-5,L.layers.mask=X.layers.mask&-3;let Le=ee.parent,Ee=X.cameras;q(X,Le);for(let je=0;je<Ee.length;je++)q(Ee[je],Le);X.projectionMatrix.copy(U.projectionMatrix),X.projectionMatrixInverse.copy(U.projectionMatrixInverse),k===null&&ee.isPerspectiveCamera&&(k={camera:ee,fov:ee.fov,zoom:ee.zoom}),j(ee,X,Le)};function j(ee,ge,Me){Me===null?ee.matrix.copy(ge.matrixWorld):(ee.matrix.copy(Me.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ge.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ge.projectionMatrix),ee.projectionMatrixInverse.copy(ge.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=lo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return X},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(X)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function pe(ee,ge){if(h=ge.getViewerPose(c||o),g=ge,h!==null){let Me=h.views;f!==null&&(e.setRenderTargetFramebuffer(M,f.framebuffer),e.setRenderTarget(M));let Le=!1;Me.length!==X.cameras.length&&(X.cameras.length=0,Le=!0);for(let Je=0;Je<Me.length;Je++){let ft=Me[Je],pt=null;if(f!==null)pt=f.getViewport(ft);else{let Ut=u.getViewSubImage(d,ft);pt=Ut.viewport,Je===0&&(e.setRenderTargetTextures(M,Ut.colorTexture,Ut.depthStencilTexture),e.setRenderTarget(M))}let ot=G[Je];ot===void 0&&(ot=new Xn,ot.layers.enable(Je),ot.viewport=new Ct,G[Je]=ot),ot.matrix.fromArray(ft.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(ft.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(pt.x,pt.y,pt.width,pt.height),Je===0&&(X.matrix.copy(ot.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),Le===!0&&X.cameras.push(ot)}let Ee=s.enabledFeatures;if(Ee&&Ee.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){u=n.getBinding();let Je=u.getDepthInformation(Me[0]);Je&&Je.isValid&&Je.texture&&p.init(Je,s.renderState)}if(Ee&&Ee.includes("camera-access")&&b){e.state.unbindTexture(),u=n.getBinding();for(let Je=0;Je<Me.length;Je++){let ft=Me[Je].camera;if(ft){let pt=m[ft];pt||(pt=new fa,m[ft]=pt);let ot=u.getCameraImage(ft);pt.sourceTexture=ot}}}}for(let Me=0;Me<R.length;Me++){let Le=E[Me],Ee=R[Me];Le!==null&&Ee!==void 0&&Ee.update(Le,ge,c||o)}ie&&ie(ee,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),g=null}let he=new a0;he.setAnimationLoop(pe),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},Qw=new bt,_0=new at;_0.set(-1,0,0,0,1,0,0,0,1);function eT(i,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function n(p,m){m.color.getRGB(p.fogColor.value,Dd(i)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,v,C,M){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,M)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),b(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,v,C):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===$n&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===$n&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let v=e.get(m),C=v.envMap,M=v.envMapRotation;C&&(p.envMap.value=C,p.envMapRotation.value.setFromMatrix4(Qw.makeRotationFromEuler(M)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(_0),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,v,C){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*v,p.scale.value=C*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,v){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===$n&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function b(p,m){let v=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function tT(i,e,t,n){let s={},r={};function o(v,C){let M=C.program;n.uniformBlockBinding(v,M,s[v.id])}function a(v,C){let M=s[v.id];M===void 0&&(g(v),M=l(v),s[v.id]=M,v.addEventListener("dispose",p));let R=C.program;n.updateUBOMapping(v,R);let E=e.render.frame;r[v.id]!==E&&(c(v),r[v.id]=E)}function l(v){let C=i.createBuffer(),M=v.__size,R=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,C),i.bufferData(i.UNIFORM_BUFFER,M,R),i.bindBuffer(i.UNIFORM_BUFFER,null),C}function c(v){let C=s[v.id],M=v.uniforms,R=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,C);for(let E=0,y=M.length;E<y;E++){let A=M[E];if(Array.isArray(A))for(let k=0,U=A.length;k<U;k++)h(A[k],E,k,R);else h(A,E,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,C,M,R){if(d(v,C,M,R)===!0){let E=v.__offset,y=v.value;if(Array.isArray(y)){let A=0;for(let k=0;k<y.length;k++){let U=y[k],L=b(U,!0);u(U,v.__data,A),A+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,v.__data)}}function u(v,C,M){typeof v=="number"||typeof v=="boolean"?C[M]=v:v.isMatrix3?(C[M]=v.elements[0],C[M+1]=v.elements[1],C[M+2]=v.elements[2],C[M+3]=0,C[M+4]=v.elements[3],C[M+5]=v.elements[4],C[M+6]=v.elements[5],C[M+7]=0,C[M+8]=v.elements[6],C[M+9]=v.elements[7],C[M+10]=v.elements[8],C[M+11]=0):ArrayBuffer.isView(v)?C.set(v.subarray(0,C.length-M),M):v.toArray(C,M)}function d(v,C,M,R){let E=v.value,y=C+"_"+M;if(Array.isArray(E)){R[y]===void 0&&(R[y]=[]);let A=R[y],k=!1;for(let U=0;U<E.length;U++)f(E[U],A,U)===!0&&(k=!0);return k}return f(E,R,y)}function f(v,C,M){if(C[M]===void 0)return typeof v=="number"||typeof v=="boolean"?C[M]=v:ArrayBuffer.isView(v)?C[M]=v.slice():C[M]=v.clone(),!0;{let R=C[M];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return C[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function g(v){let C=v.uniforms,M=0,R=16;for(let y=0,A=C.length;y<A;y++){let k=Array.isArray(C[y])?C[y]:[C[y]];for(let U=0,L=k.length;U<L;U++){let G=k[U],X=Array.isArray(G.value)?G.value:[G.value],D=Array.isArray(C[y])||Array.isArray(G.value),V=M;for(let H=0,ce=X.length;H<ce;H++){let q=X[H],j=b(q,D),ie=M%R,pe=ie%j.boundary,he=ie+pe;M+=pe,he!==0&&R-he<j.storage&&(M+=R-he),H===0&&(V=M),M+=j.storage}let Y=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new Y((M-V)/Float32Array.BYTES_PER_ELEMENT),G.__offset=V}}let E=M%R;return E>0&&(M+=R-E),v.__size=M,v.__cache={},this}function b(v,C){let M={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?rt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):rt("WebGLRenderer: Unsupported uniform value type.",v),C===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function p(v){let C=v.target;C.removeEventListener("dispose",p),i.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function m(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var nT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ji=null;function iT(){return Ji===null&&(Ji=new ic(nT,16,16,Ws,Li),Ji.name="DFG_LUT",Ji.minFilter=Yn,Ji.magFilter=Yn,Ji.wrapS=Wi,Ji.wrapT=Wi,Ji.generateMipmaps=!1,Ji.needsUpdate=!0),Ji}var Da=class{constructor(e={}){let{canvas:t=Ig(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Kn}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let b=f,p=new Set([Ic,Pc,Rc]),m=new Set([Kn,Pi,wo,fr,Ec,Cc]),v=new Uint32Array(4),C=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},R=null,E=null,y=[],A=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Zi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,L=!1,G=null,X=null,D=null,V=null;this._outputColorSpace=Vn;let Y=0,H=0,ce=null,q=-1,j=null,ie=new Ct,pe=new Ct,he=null,ee=new nt(0),ge=0,Me=t.width,Le=t.height,Ee=1,je=null,ut=null,Je=new Ct(0,0,Me,Le),ft=new Ct(0,0,Me,Le),pt=!1,ot=new Yi,Ut=new sc,Lt=!1,Wt=!1,K=new bt,de=new F,xe=new Ct,Se={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},_e=!1;function $e(){return ce===null?Ee:1}let P=n;function ue(w,z){return t.getContext(w,z)}let ke,Ue,ye,Xe,Te,Ge,T,x,B,se,Q,me,ve,te,re,be,O,ae,oe,Pe,Ae,Re,Qe;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Fe,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),P===null){let z="webgl2";if(P=ue(z,w),P===null)throw ue(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}st()}catch(w){throw t.removeEventListener("webglcontextlost",Fe,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),ht("WebGLRenderer: "+w.message),w}function st(){ke=new pS(P),ke.init(),Ae=new Jw(P,ke),Ue=new iS(P,ke,e,Ae),ye=new $w(P,ke),Ue.reversedDepthBuffer&&d&&ye.buffers.depth.setReversed(!0),X=P.createFramebuffer(),D=P.createFramebuffer(),V=P.createFramebuffer(),Xe=new _S(P),Te=new Nw,Ge=new Zw(P,ke,ye,Te,Ue,Ae,Xe),T=new fS(U),x=new yv(P),Re=new tS(P,x),B=new mS(P,x,Xe,Re),se=new yS(P,B,x,Re,Xe),ae=new xS(P,Ue,Ge),re=new sS(Te),Q=new Dw(U,T,ke,Ue,Re,re),me=new eT(U,Te),ve=new Ow,te=new Hw(ke),O=new eS(U,T,ye,se,g,l),be=new qw(U,se,Ue),Qe=new tT(P,Xe,Ue,ye),oe=new nS(P,ke,Xe),Pe=new gS(P,ke,Xe),Xe.programs=Q.programs,U.capabilities=Ue,U.extensions=ke,U.properties=Te,U.renderLists=ve,U.shadowMap=be,U.state=ye,U.info=Xe}b!==Kn&&(k=new bS(b,t.width,t.height,a,s,r));let le=new Yd(U,P);this.xr=le,this.getContext=function(){return P},this.getContextAttributes=function(){return P.getContextAttributes()},this.forceContextLoss=function(){let w=ke.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=ke.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Ee},this.setPixelRatio=function(w){w!==void 0&&(Ee=w,this.setSize(Me,Le,!1))},this.getSize=function(w){return w.set(Me,Le)},this.setSize=function(w,z,ne=!0){if(le.isPresenting){rt("WebGLRenderer: Can't change size while VR device is presenting.");return}Me=w,Le=z,t.width=Math.floor(w*Ee),t.height=Math.floor(z*Ee),ne===!0&&(t.style.width=w+"px",t.style.height=z+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,w,z)},this.getDrawingBufferSize=function(w){return w.set(Me*Ee,Le*Ee).floor()},this.setDrawingBufferSize=function(w,z,ne){Me=w,Le=z,Ee=ne,t.width=Math.floor(w*ne),t.height=Math.floor(z*ne),this.setViewport(0,0,w,z)},this.setEffects=function(w){if(b===Kn){ht("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let z=0;z<w.length;z++)if(w[z].isOutputPass===!0){rt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ie)},this.getViewport=function(w){return w.copy(Je)},this.setViewport=function(w,z,ne,$){w.isVector4?Je.set(w.x,w.y,w.z,w.w):Je.set(w,z,ne,$),ye.viewport(ie.copy(Je).multiplyScalar($e()).round())},this.getScissor=function(w){return w.copy(ft)},this.setScissor=function(w,z,ne,$){w.isVector4?ft.set(w.x,w.y,w.z,w.w):ft.set(w,z,ne,$),ye.scissor(pe.copy(ft).multiplyScalar($e()).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(w){ye.setScissorTest(pt=w)},this.setOpaqueSort=function(w){je=w},this.setTransparentSort=function(w){ut=w},this.getClearColor=function(w){return w.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(w=!0,z=!0,ne=!0){let $=0;if(w){let Z=!1;if(ce!==null){let De=ce.texture.format;Z=p.has(De)}if(Z){let De=ce.texture.type,Oe=m.has(De),Ne=O.getClearColor(),Be=O.getClearAlpha(),Ke=Ne.r,dt=Ne.g,xt=Ne.b;Oe?(v[0]=Ke,v[1]=dt,v[2]=xt,v[3]=Be,P.clearBufferuiv(P.COLOR,0,v)):(C[0]=Ke,C[1]=dt,C[2]=xt,C[3]=Be,P.clearBufferiv(P.COLOR,0,C))}else $|=P.COLOR_BUFFER_BIT}z&&($|=P.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ne&&($|=P.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&P.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),G=w},this.dispose=function(){t.removeEventListener("webglcontextlost",Fe,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),O.dispose(),ve.dispose(),te.dispose(),Ge.dispose(),Te.dispose(),T.dispose(),se.dispose(),B.dispose(),Re.dispose(),Qe.dispose(),Q.dispose(),le.dispose(),le.removeEventListener("sessionstart",Ga),le.removeEventListener("sessionend",Ni),ji.stop()};function Fe(w){w.preventDefault(),ra("WebGLRenderer: Context Lost."),L=!0}function tt(){ra("WebGLRenderer: Context Restored."),L=!1;let w=Xe.autoReset,z=be.enabled,ne=be.autoUpdate,$=be.needsUpdate,Z=be.type;st(),Xe.autoReset=w,be.enabled=z,be.autoUpdate=ne,be.needsUpdate=$,be.type=Z}function Ce(w){ht("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function lt(w){let z=w.target;z.removeEventListener("dispose",lt),zt(z)}function zt(w){In(w),Te.remove(w)}function In(w){let z=Te.get(w).programs;z!==void 0&&(z.forEach(function(ne){Q.releaseProgram(ne)}),w.isShaderMaterial&&Q.releaseShaderCache(w))}this.renderBufferDirect=function(w,z,ne,$,Z,De){z===null&&(z=Se);let Oe=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ne=Po(w,z,ne,$,Z);ye.setMaterial($,Oe);let Be=ne.index,Ke=1;if($.wireframe===!0){if(Be=B.getWireframeAttribute(ne),Be===void 0)return;Ke=2}let dt=ne.drawRange,xt=ne.attributes.position,Ze=dt.start*Ke,yt=(dt.start+dt.count)*Ke;De!==null&&(Ze=Math.max(Ze,De.start*Ke),yt=Math.min(yt,(De.start+De.count)*Ke)),Be!==null?(Ze=Math.max(Ze,0),yt=Math.min(yt,Be.count)):xt!=null&&(Ze=Math.max(Ze,0),yt=Math.min(yt,xt.count));let Kt=yt-Ze;if(Kt<0||Kt===1/0)return;Re.setup(Z,$,Ne,ne,Be);let Ot,Ft=oe;if(Be!==null&&(Ot=x.get(Be),Ft=Pe,Ft.setIndex(Ot)),Z.isMesh)$.wireframe===!0?(ye.setLineWidth($.wireframeLinewidth*$e()),Ft.setMode(P.LINES)):Ft.setMode(P.TRIANGLES);else if(Z.isLine){let pn=$.linewidth;pn===void 0&&(pn=1),ye.setLineWidth(pn*$e()),Z.isLineSegments?Ft.setMode(P.LINES):Z.isLineLoop?Ft.setMode(P.LINE_LOOP):Ft.setMode(P.LINE_STRIP)}else Z.isPoints?Ft.setMode(P.POINTS):Z.isSprite&&Ft.setMode(P.TRIANGLES);if(Z.isBatchedMesh)if(ke.get("WEBGL_multi_draw"))Ft.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let pn=Z._multiDrawStarts,We=Z._multiDrawCounts,ln=Z._multiDrawCount,St=Be?x.get(Be).bytesPerElement:1,es=Te.get($).currentProgram.getUniforms();for(let cn=0;cn<ln;cn++)es.setValue(P,"_gl_DrawID",cn),Ft.render(pn[cn]/St,We[cn])}else if(Z.isInstancedMesh)Ft.renderInstances(Ze,Kt,Z.count);else if(ne.isInstancedBufferGeometry){let pn=ne._maxInstanceCount!==void 0?ne._maxInstanceCount:1/0,We=Math.min(ne.instanceCount,pn);Ft.renderInstances(Ze,Kt,We)}else Ft.render(Ze,Kt)};function Eo(w,z,ne,$){G!==null&&w.isNodeMaterial&&G.setObject($,w),Lt===!0&&re.setState(w,ne,!1),w.transparent===!0&&w.side===Zn&&w.forceSinglePass===!1?(w.side=$n,w.needsUpdate=!0,Ui(w,z,$),w.side=Vs,w.needsUpdate=!0,Ui(w,z,$),w.side=Zn):Ui(w,z,$)}this.compile=function(w,z,ne=null){ne===null&&(ne=w),G!==null&&G.renderStart(w,z,ne),E=te.get(ne),E.init(z),A.push(E),ne.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),w!==ne&&w.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),E.setupLights(),G!==null&&G.updateLights(E.state.lightsArray),Wt=this.localClippingEnabled,Lt=re.init(this.clippingPlanes,Wt),Lt===!0&&re.setGlobalState(this.clippingPlanes,z),G!==null&&be.render(E.state.shadowsArray,ne,z);let $=new Set;return w.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let De=Z.material;if(De)if(Array.isArray(De))for(let Oe=0;Oe<De.length;Oe++){let Ne=De[Oe];Eo(Ne,ne,z,Z),$.add(Ne)}else Eo(De,ne,z,Z),$.add(De)}),E=A.pop(),G!==null&&G.renderEnd(),$},this.compileAsync=function(w,z,ne=null){let $=this.compile(w,z,ne);return new Promise(Z=>{function De(){if($.forEach(function(Oe){let Be=Te.get(Oe).currentProgram;(Be===void 0||Be.isReady())&&$.delete(Oe)}),$.size===0){Z(w);return}setTimeout(De,10)}ke.get("KHR_parallel_shader_compile")!==null?De():setTimeout(De,10)})};let gr=null;function Oh(w){gr&&gr(w)}function Ga(){ji.stop()}function Ni(){ji.start()}let ji=new a0;ji.setAnimationLoop(Oh),typeof self<"u"&&ji.setContext(self),this.setAnimationLoop=function(w){gr=w,le.setAnimationLoop(w),w===null?ji.stop():ji.start()},le.addEventListener("sessionstart",Ga),le.addEventListener("sessionend",Ni),this.render=function(w,z){if(z!==void 0&&z.isCamera!==!0){ht("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;G!==null&&G.renderStart(w,z);let ne=le.enabled===!0&&le.isPresenting===!0,$=k!==null&&(ce===null||ne)&&k.begin(U,ce);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(z),z=le.getCamera()),w.isScene===!0&&w.onBeforeRender(U,w,z,ce),E=te.get(w,A.length),E.init(z),E.state.textureUnits=Ge.getTextureUnits(),A.push(E),K.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Ut.setFromArrayCamera(z):ot.setFromProjectionMatrix(K,gi,z.reversedDepth),Wt=this.localClippingEnabled,Lt=re.init(this.clippingPlanes,Wt),R=ve.get(w,y.length),R.init(),y.push(R),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Oe=U.xr.getDepthSensingMesh();Oe!==null&&Qi(Oe,z,-1/0,U.sortObjects)}Qi(w,z,0,U.sortObjects),R.finish(),G!==null&&G.updateLights(E.state.lightsArray),U.sortObjects===!0&&R.sort(je,ut),_e=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,_e&&O.addToRenderList(R,w),this.info.autoReset===!0&&this.info.reset(),Lt===!0&&re.beginShadows();let Z=E.state.shadowsArray;if(be.render(Z,w,z),Lt===!0&&re.endShadows(),($&&k.hasRenderPass())===!1){let Oe=R.opaque,Ne=R.transmissive;if(E.setupLights(),z.isArrayCamera){let Be=z.cameras;if(Ne.length>0)for(let Ke=0,dt=Be.length;Ke<dt;Ke++){let xt=Be[Ke];xi(Oe,Ne,w,xt)}_e&&O.render(w);for(let Ke=0,dt=Be.length;Ke<dt;Ke++){let xt=Be[Ke];Co(R,w,xt,xt.viewport)}}else Ne.length>0&&xi(Oe,Ne,w,z),_e&&O.render(w),Co(R,w,z)}ce!==null&&H===0&&(Ge.updateMultisampleRenderTarget(ce),Ge.updateRenderTargetMipmap(ce)),$&&k.end(U),w.isScene===!0&&w.onAfterRender(U,w,z),Re.resetDefaultState(),q=-1,j=null,A.pop(),A.length>0?(E=A[A.length-1],Ge.setTextureUnits(E.state.textureUnits),Lt===!0&&re.setGlobalState(U.clippingPlanes,E.state.camera)):E=null,y.pop(),y.length>0?R=y[y.length-1]:R=null,G!==null&&G.renderEnd()};function Qi(w,z,ne,$){if(w.visible===!1)return;if(w.layers.test(z.layers)){if(w.isGroup)ne=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(z);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let Oe=z.isArrayCamera?Ut:ot;if(!w.frustumCulled||w.intersectsFrustum(Oe)){$&&xe.setFromMatrixPosition(w.matrixWorld).applyMatrix4(K);let Ne=se.update(w),Be=w.material;Be.visible&&R.push(w,Ne,Be,ne,xe.z,null,z)}}else if(w.isMesh||w.isLine||w.isPoints){let Oe=z.isArrayCamera?Ut:ot;if(!w.frustumCulled||w.intersectsFrustum(Oe)){let Ne=se.update(w),Be=w.material;if($&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),xe.copy(w.boundingSphere.center)):(Ne.boundingSphere===null&&Ne.computeBoundingSphere(),xe.copy(Ne.boundingSphere.center)),xe.applyMatrix4(w.matrixWorld).applyMatrix4(K)),Array.isArray(Be)){let Ke=Ne.groups;for(let dt=0,xt=Ke.length;dt<xt;dt++){let Ze=Ke[dt],yt=Be[Ze.materialIndex];yt&&yt.visible&&R.push(w,Ne,yt,ne,xe.z,Ze,z)}}else Be.visible&&R.push(w,Ne,Be,ne,xe.z,null,z)}}}let De=w.children;for(let Oe=0,Ne=De.length;Oe<Ne;Oe++)Qi(De[Oe],z,ne,$)}function Co(w,z,ne,$){let{opaque:Z,transmissive:De,transparent:Oe}=w;E.setupLightsView(ne),Lt===!0&&re.setGlobalState(U.clippingPlanes,ne),$&&ye.viewport(ie.copy($)),Z.length>0&&Qt(Z,z,ne),De.length>0&&Qt(De,z,ne),Oe.length>0&&Qt(Oe,z,ne),ye.buffers.depth.setTest(!0),ye.buffers.depth.setMask(!0),ye.buffers.color.setMask(!0),ye.setPolygonOffset(!1)}function xi(w,z,ne,$){if((ne.isScene===!0?ne.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[$.id]===void 0){let Ze=ke.has("EXT_color_buffer_half_float")||ke.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[$.id]=new ci(1,1,{generateMipmaps:!0,type:Ze?Li:Kn,minFilter:_s,samples:Math.max(4,Ue.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Tt.workingColorSpace})}let De=E.state.transmissionRenderTarget[$.id],Oe=$.viewport||ie;De.setSize(Oe.z*U.transmissionResolutionScale,Oe.w*U.transmissionResolutionScale);let Ne=U.getRenderTarget(),Be=U.getActiveCubeFace(),Ke=U.getActiveMipmapLevel();U.setRenderTarget(De),U.getClearColor(ee),ge=U.getClearAlpha(),ge<1&&U.setClearColor(16777215,.5),U.clear(),_e&&O.render(ne);let dt=U.toneMapping;U.toneMapping=Zi;let xt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),E.setupLightsView($),Lt===!0&&re.setGlobalState(U.clippingPlanes,$),Qt(w,ne,$),Ge.updateMultisampleRenderTarget(De),Ge.updateRenderTargetMipmap(De),ke.has("WEBGL_multisampled_render_to_texture")===!1){let Ze=!1;for(let yt=0,Kt=z.length;yt<Kt;yt++){let Ot=z[yt],{object:Ft,geometry:pn,material:We,group:ln}=Ot;if(We.side===Zn&&Ft.layers.test($.layers)){let St=We.side;We.side=$n,We.needsUpdate=!0,sn(Ft,ne,$,pn,We,ln),We.side=St,We.needsUpdate=!0,Ze=!0}}Ze===!0&&(Ge.updateMultisampleRenderTarget(De),Ge.updateRenderTargetMipmap(De))}U.setRenderTarget(Ne,Be,Ke),U.setClearColor(ee,ge),xt!==void 0&&($.viewport=xt),U.toneMapping=dt}function Qt(w,z,ne){let $=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,De=w.length;Z<De;Z++){let Oe=w[Z],{object:Ne,geometry:Be,group:Ke}=Oe,dt=Oe.material;dt.allowOverride===!0&&$!==null&&(dt=$),Ne.layers.test(ne.layers)&&sn(Ne,z,ne,Be,dt,Ke)}}function sn(w,z,ne,$,Z,De){G!==null&&Z.isNodeMaterial&&G.setObject(w,Z),w.onBeforeRender(U,z,ne,$,Z,De),w.modelViewMatrix.multiplyMatrices(ne.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),Z.onBeforeRender(U,z,ne,$,w,De),Z.transparent===!0&&Z.side===Zn&&Z.forceSinglePass===!1?(Z.side=$n,Z.needsUpdate=!0,U.renderBufferDirect(ne,z,$,Z,w,De),Z.side=Vs,Z.needsUpdate=!0,U.renderBufferDirect(ne,z,$,Z,w,De),Z.side=Zn):U.renderBufferDirect(ne,z,$,Z,w,De),w.onAfterRender(U,z,ne,$,Z,De)}function rn(w){let z=0;for(let ne of w)ne.texture!==null&&z++;return z}function Ui(w,z,ne){z.isScene!==!0&&(z=Se);let $=Te.get(w),Z=E.state.lights,De=E.state.shadowsArray,Oe=Z.state.version,Ne=Q.getParameters(w,Z.state,De,z,ne,E.state.lightProbeGridArray),Be=Q.getProgramCacheKey(Ne),Ke=$.programs;$.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?z.environment:null,$.fog=z.fog;let dt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;$.envMap=T.get(w.envMap||$.environment,dt),$.envMapRotation=$.environment!==null&&w.envMap===null?z.environmentRotation:w.envMapRotation,Ke===void 0&&(w.addEventListener("dispose",lt),Ke=new Map,$.programs=Ke,$.programVariants=new Map);let xt=Ke.get(Be);if(xt!==void 0){if($.currentProgram===xt&&$.lightsStateVersion===Oe)return Ro(w,Ne),xt}else Ne.uniforms=Q.getUniforms(w),G!==null&&w.isNodeMaterial&&G.build(w,ne,Ne),w.onBeforeCompile(Ne,U),xt=Q.acquireProgram(Ne,Be),Ke.set(Be,xt),$.uniforms=Ne.uniforms;let Ze=$.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Ze.clippingPlanes=re.uniform),Ro(w,Ne),$.needsLights=ws(w),$.lightsStateVersion=Oe,$.needsLights&&(Ze.ambientLightColor.value=Z.state.ambient,Ze.lightProbe.value=Z.state.probe,Ze.sunLights.value=Z.state.sun,Ze.sunLightShadows.value=Z.state.sunShadow,Ze.directionalLights.value=Z.state.directional,Ze.directionalLightShadows.value=Z.state.directionalShadow,Ze.spotLights.value=Z.state.spot,Ze.spotLightShadows.value=Z.state.spotShadow,Ze.rectAreaLights.value=Z.state.rectArea,Ze.ltc_1.value=Z.state.rectAreaLTC1,Ze.ltc_2.value=Z.state.rectAreaLTC2,Ze.pointLights.value=Z.state.point,Ze.pointLightShadows.value=Z.state.pointShadow,Ze.hemisphereLights.value=Z.state.hemi,Ze.sunShadowMatrix.value=Z.state.sunShadowMatrix,Ze.sunShadowCascade.value=Z.state.sunShadowCascade,Ze.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Ze.spotLightMatrix.value=Z.state.spotLightMatrix,Ze.spotLightMap.value=Z.state.spotLightMap,Ze.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=rn(E.state.lightProbeGridArray),$.currentProgram=xt,$.uniformsList=null,xt}function Qn(w,z,ne,$,Z){let De=Te.get(w),Oe=De.currentProgram.id+","+$+","+Z,Ne=De.programVariants.get(Oe);return Ne===void 0?(Ne=Ui(w,z,ne),De.programVariants.set(Oe,Ne)):(De.currentProgram=Ne,De.uniformsList=null,De.outputColorSpace=$,De.toneMapping=Z),Ne}function Ss(w){if(w.uniformsList===null){let z=w.currentProgram.getUniforms();w.uniformsList=To.seqWithValue(z.seq,w.uniforms)}return w.uniformsList}function Ro(w,z){let ne=Te.get(w);ne.outputColorSpace=z.outputColorSpace,ne.batching=z.batching,ne.batchingColor=z.batchingColor,ne.instancing=z.instancing,ne.instancingColor=z.instancingColor,ne.instancingMorph=z.instancingMorph,ne.skinning=z.skinning,ne.morphTargets=z.morphTargets,ne.morphNormals=z.morphNormals,ne.morphColors=z.morphColors,ne.morphTargetsCount=z.morphTargetsCount,ne.numClippingPlanes=z.numClippingPlanes,ne.numIntersection=z.numClipIntersection,ne.vertexAlphas=z.vertexAlphas,ne.vertexTangents=z.vertexTangents,ne.toneMapping=z.toneMapping}function Po(w,z,ne,$,Z){z.isScene!==!0&&(z=Se),Ge.resetTextureUnits();let De=z.fog,Oe=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?z.environment:null,Ne=ce===null?U.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:Tt.workingColorSpace,Be=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Ke=T.get($.envMap||Oe,Be),dt=$.vertexColors===!0&&!!ne.attributes.color&&ne.attributes.color.itemSize===4,xt=!!ne.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Ze=!!ne.morphAttributes.position,yt=!!ne.morphAttributes.normal,Kt=!!ne.morphAttributes.color,Ot=Zi;$.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Ot=U.toneMapping);let Ft=ne.morphAttributes.position||ne.morphAttributes.normal||ne.morphAttributes.color,pn=Ft!==void 0?Ft.length:0,We=Te.get($),ln=E.state.lights;if(Lt===!0&&(Wt===!0||w!==j)){let Bt=w===j&&$.id===q;re.setState($,w,Bt)}let St=!1,es=!1;$.version===We.__version?We.needsLights&&We.lightsStateVersion!==ln.state.version||Z.isBatchedMesh&&We.batching===!1||!Z.isBatchedMesh&&We.batching===!0||Z.isBatchedMesh&&We.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&We.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&We.instancing===!1||!Z.isInstancedMesh&&We.instancing===!0||Z.isSkinnedMesh&&We.skinning===!1||!Z.isSkinnedMesh&&We.skinning===!0||Z.isInstancedMesh&&We.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&We.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&We.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&We.instancingMorph===!1&&Z.morphTexture!==null||We.envMap!==Ke||$.fog===!0&&We.fog!==De||We.numClippingPlanes!==void 0&&(We.numClippingPlanes!==re.numPlanes||We.numIntersection!==re.numIntersection)||We.vertexAlphas!==dt||We.vertexTangents!==xt||We.morphTargets!==Ze||We.morphNormals!==yt||We.morphColors!==Kt||We.morphTargetsCount!==pn||We.numLightProbeGrids!==rn(E.state.lightProbeGridArray)?St=!0:(We.outputColorSpace!==Ne||We.toneMapping!==Ot)&&(es=!0):(St=!0,We.__version=$.version);let cn=We.currentProgram;(St===!0||es===!0)&&(cn=es===!0?Qn($,z,Z,Ne,Ot):Ui($,z,Z),G&&$.isNodeMaterial&&G.onUpdateProgram($,cn,We));let yr=!1,Oi=!1,ts=!1,gt=cn.getUniforms(),en=We.uniforms;if(ye.useProgram(cn.program)&&(yr=!0,Oi=!0,ts=!0),$.id!==q&&(q=$.id,Oi=!0),yr||j!==w){ye.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),gt.setValue(P,"projectionMatrix",w.projectionMatrix),gt.setValue(P,"viewMatrix",w.matrixWorldInverse);let hn=gt.map.cameraPosition;hn!==void 0&&hn.setValue(P,de.setFromMatrixPosition(w.matrixWorld)),Ue.logarithmicDepthBuffer&&gt.setValue(P,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&gt.setValue(P,"isOrthographic",w.isOrthographicCamera===!0),j!==w&&(j=w,Oi=!0,ts=!0)}if(We.needsLights&&(ln.state.sunShadowMap.length>0&&gt.setValue(P,"sunShadowMap",ln.state.sunShadowMap,Ge),ln.state.directionalShadowMap.length>0&&gt.setValue(P,"directionalShadowMap",ln.state.directionalShadowMap,Ge),ln.state.spotShadowMap.length>0&&gt.setValue(P,"spotShadowMap",ln.state.spotShadowMap,Ge),ln.state.pointShadowMap.length>0&&gt.setValue(P,"pointShadowMap",ln.state.pointShadowMap,Ge)),Z.isSkinnedMesh){gt.setOptional(P,Z,"bindMatrix"),gt.setOptional(P,Z,"bindMatrixInverse");let Bt=Z.skeleton;Bt&&(Bt.boneTexture===null&&Bt.computeBoneTexture(),gt.setValue(P,"boneTexture",Bt.boneTexture,Ge))}Z.isBatchedMesh&&(gt.setOptional(P,Z,"batchingTexture"),gt.setValue(P,"batchingTexture",Z._matricesTexture,Ge),gt.setOptional(P,Z,"batchingIdTexture"),gt.setValue(P,"batchingIdTexture",Z._indirectTexture,Ge),gt.setOptional(P,Z,"batchingColorTexture"),Z._colorsTexture!==null&&gt.setValue(P,"batchingColorTexture",Z._colorsTexture,Ge));let Fn=ne.morphAttributes;if((Fn.position!==void 0||Fn.normal!==void 0||Fn.color!==void 0)&&ae.update(Z,ne,cn),(Oi||We.receiveShadow!==Z.receiveShadow)&&(We.receiveShadow=Z.receiveShadow,gt.setValue(P,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&z.environment!==null&&(en.envMapIntensity.value=z.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=iT()),Oi){if(gt.setValue(P,"toneMappingExposure",U.toneMappingExposure),We.needsLights&&_r(en,ts),De&&$.fog===!0&&me.refreshFogUniforms(en,De),me.refreshMaterialUniforms(en,$,Ee,Le,E.state.transmissionRenderTarget[w.id]),We.needsLights&&We.numLightProbeGrids>0){let Bt=M,hn=0;for(let Ln of E.state.lightProbeGridArray)Ln.texture!==null&&(Bt.textures[hn]=Ln.texture,Bt.min[hn]=Ln.boundingBox.min,Bt.max[hn]=Ln.boundingBox.max,Bt.resolution[hn]=Ln.resolution,hn++);for(let Ln in Bt)Bt[Ln].length=hn;en.probesSH.value=Bt.textures,en.probesMin.value=Bt.min,en.probesMax.value=Bt.max,en.probesResolution.value=Bt.resolution}To.upload(P,Ss(We),en,Ge)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(To.upload(P,Ss(We),en,Ge),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&gt.setValue(P,"center",Z.center),gt.setValue(P,"modelViewMatrix",Z.modelViewMatrix),gt.setValue(P,"normalMatrix",Z.normalMatrix),gt.setValue(P,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Bt=$.uniformsGroups;for(let hn=0,Ln=Bt.length;hn<Ln;hn++){let Ha=Bt[hn];Qe.update(Ha,cn),Qe.bind(Ha,cn)}}return cn}function _r(w,z){w.ambientLightColor.needsUpdate=z,w.lightProbe.needsUpdate=z,w.sunLights.needsUpdate=z,w.sunLightShadows.needsUpdate=z,w.directionalLights.needsUpdate=z,w.directionalLightShadows.needsUpdate=z,w.pointLights.needsUpdate=z,w.pointLightShadows.needsUpdate=z,w.spotLights.needsUpdate=z,w.spotLightShadows.needsUpdate=z,w.rectAreaLights.needsUpdate=z,w.hemisphereLights.needsUpdate=z}function ws(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(w,z,ne){let $=Te.get(w);$.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Te.get(w.texture).__webglTexture=z,Te.get(w.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:ne,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,z){let ne=Te.get(w);ne.__webglFramebuffer=z,ne.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(w,z=0,ne=0){ce=w,Y=z,H=ne;let $=null,Z=!1,De=!1;if(w){let Ne=Te.get(w);if(Ne.__useDefaultFramebuffer!==void 0){ye.bindFramebuffer(P.FRAMEBUFFER,Ne.__webglFramebuffer),ie.copy(w.viewport),pe.copy(w.scissor),he=w.scissorTest,ye.viewport(ie),ye.scissor(pe),ye.setScissorTest(he),q=-1;return}else if(Ne.__webglFramebuffer===void 0)Ge.setupRenderTarget(w);else if(Ne.__hasExternalTextures)Ge.rebindTextures(w,Te.get(w.texture).__webglTexture,Te.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let dt=w.depthTexture;if(Ne.__boundDepthTexture!==dt){if(dt!==null&&Te.has(dt)&&(w.width!==dt.image.width||w.height!==dt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ge.setupDepthRenderbuffer(w)}}let Be=w.texture;(Be.isData3DTexture||Be.isDataArrayTexture||Be.isCompressedArrayTexture)&&(De=!0);let Ke=Te.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ke[z])?$=Ke[z][ne]:$=Ke[z],Z=!0):w.samples>0&&Ge.useMultisampledRTT(w)===!1?$=Te.get(w).__webglMultisampledFramebuffer:Array.isArray(Ke)?$=Ke[ne]:$=Ke,ie.copy(w.viewport),pe.copy(w.scissor),he=w.scissorTest}else ie.copy(Je).multiplyScalar(Ee).floor(),pe.copy(ft).multiplyScalar(Ee).floor(),he=pt;if(ne!==0&&($=X),ye.bindFramebuffer(P.FRAMEBUFFER,$)&&ye.drawBuffers(w,$),ye.viewport(ie),ye.scissor(pe),ye.setScissorTest(he),Z){let Ne=Te.get(w.texture);P.framebufferTexture2D(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ne.__webglTexture,ne)}else if(De){let Ne=z;for(let Be=0;Be<w.textures.length;Be++){let Ke=Te.get(w.textures[Be]);P.framebufferTextureLayer(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0+Be,Ke.__webglTexture,ne,Ne)}}else if(w!==null&&ne!==0){let Ne=Te.get(w.texture);P.framebufferTexture2D(P.FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,Ne.__webglTexture,ne)}q=-1};function xr(w){let z=Te.get(w);return(z.__readFormat!==w.format||z.__readType!==w.type)&&(z.__readFormat=w.format,z.__readType=w.type,z.__formatReadable=Ue.textureFormatReadable(w.format),z.__typeReadable=Ue.textureTypeReadable(w.type)),z}this.readRenderTargetPixels=function(w,z,ne,$,Z,De,Oe,Ne=0){if(!(w&&w.isWebGLRenderTarget)){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Be=Te.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Oe!==void 0&&(Be=Be[Oe],Array.isArray(Be)&&(Be=Be[0])),Be){ye.bindFramebuffer(P.FRAMEBUFFER,Be);try{let Ke=w.textures[Ne],dt=Ke.format,xt=Ke.type;w.textures.length>1&&P.readBuffer(P.COLOR_ATTACHMENT0+Ne);let Ze=xr(Ke);if(Ze.__formatReadable===!1){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ze.__typeReadable===!1){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=w.width-$&&ne>=0&&ne<=w.height-Z&&P.readPixels(z,ne,$,Z,Ae.convert(dt),Ae.convert(xt),De)}finally{let Ke=ce!==null?Te.get(ce).__webglFramebuffer:null;ye.bindFramebuffer(P.FRAMEBUFFER,Ke)}}},this.readRenderTargetPixelsAsync=async function(w,z,ne,$,Z,De,Oe,Ne=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Be=Te.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Oe!==void 0&&(Be=Be[Oe],Array.isArray(Be)&&(Be=Be[0])),Be)if(z>=0&&z<=w.width-$&&ne>=0&&ne<=w.height-Z){ye.bindFramebuffer(P.FRAMEBUFFER,Be);let Ke=w.textures[Ne],dt=Ke.format,xt=Ke.type;w.textures.length>1&&P.readBuffer(P.COLOR_ATTACHMENT0+Ne);let Ze=xr(Ke);if(Ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let yt=P.createBuffer();P.bindBuffer(P.PIXEL_PACK_BUFFER,yt),P.bufferData(P.PIXEL_PACK_BUFFER,De.byteLength,P.STREAM_READ),P.readPixels(z,ne,$,Z,Ae.convert(dt),Ae.convert(xt),0),P.bindBuffer(P.PIXEL_PACK_BUFFER,null);let Kt=ce!==null?Te.get(ce).__webglFramebuffer:null;ye.bindFramebuffer(P.FRAMEBUFFER,Kt);let Ot=P.fenceSync(P.SYNC_GPU_COMMANDS_COMPLETE,0);return P.flush(),await Dg(P,Ot,4),P.bindBuffer(P.PIXEL_PACK_BUFFER,yt),P.getBufferSubData(P.PIXEL_PACK_BUFFER,0,De),P.bindBuffer(P.PIXEL_PACK_BUFFER,null),P.deleteBuffer(yt),P.deleteSync(Ot),De}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,z=null,ne=0){let $=Math.pow(2,-ne),Z=Math.floor(w.image.width*$),De=Math.floor(w.image.height*$),Oe=z!==null?z.x:0,Ne=z!==null?z.y:0;Ge.setTexture2D(w,0),P.copyTexSubImage2D(P.TEXTURE_2D,ne,0,0,Oe,Ne,Z,De),ye.unbindTexture()},this.copyTextureToTexture=function(w,z,ne=null,$=null,Z=0,De=0){let Oe,Ne,Be,Ke,dt,xt,Ze,yt,Kt,Ot=w.isCompressedTexture?w.mipmaps[De]:w.image;if(ne!==null)Oe=ne.max.x-ne.min.x,Ne=ne.max.y-ne.min.y,Be=ne.isBox3?ne.max.z-ne.min.z:1,Ke=ne.min.x,dt=ne.min.y,xt=ne.isBox3?ne.min.z:0;else{let gt=Math.pow(2,-Z);Oe=Math.floor(Ot.width*gt),Ne=Math.floor(Ot.height*gt),w.isDataArrayTexture?Be=Ot.depth:w.isData3DTexture?Be=Math.floor(Ot.depth*gt):Be=1,Ke=0,dt=0,xt=0}$!==null?(Ze=$.x,yt=$.y,Kt=$.z):(Ze=0,yt=0,Kt=0);let Ft=Ae.convert(z.format),pn=Ae.convert(z.type),We;z.isData3DTexture?(Ge.setTexture3D(z,0),We=P.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ge.setTexture2DArray(z,0),We=P.TEXTURE_2D_ARRAY):(Ge.setTexture2D(z,0),We=P.TEXTURE_2D),ye.activeTexture(P.TEXTURE0),ye.pixelStorei(P.UNPACK_FLIP_Y_WEBGL,z.flipY),ye.pixelStorei(P.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),ye.pixelStorei(P.UNPACK_ALIGNMENT,z.unpackAlignment);let ln=ye.getParameter(P.UNPACK_ROW_LENGTH),St=ye.getParameter(P.UNPACK_IMAGE_HEIGHT),es=ye.getParameter(P.UNPACK_SKIP_PIXELS),cn=ye.getParameter(P.UNPACK_SKIP_ROWS),yr=ye.getParameter(P.UNPACK_SKIP_IMAGES);ye.pixelStorei(P.UNPACK_ROW_LENGTH,Ot.width),ye.pixelStorei(P.UNPACK_IMAGE_HEIGHT,Ot.height),ye.pixelStorei(P.UNPACK_SKIP_PIXELS,Ke),ye.pixelStorei(P.UNPACK_SKIP_ROWS,dt),ye.pixelStorei(P.UNPACK_SKIP_IMAGES,xt);let Oi=w.isDataArrayTexture||w.isData3DTexture,ts=z.isDataArrayTexture||z.isData3DTexture;if(w.isDepthTexture){let gt=Te.get(w),en=Te.get(z),Fn=Te.get(gt.__renderTarget),Bt=Te.get(en.__renderTarget);ye.bindFramebuffer(P.READ_FRAMEBUFFER,Fn.__webglFramebuffer),ye.bindFramebuffer(P.DRAW_FRAMEBUFFER,Bt.__webglFramebuffer);for(let hn=0;hn<Be;hn++)Oi&&(P.framebufferTextureLayer(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,Te.get(w).__webglTexture,Z,xt+hn),P.framebufferTextureLayer(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,Te.get(z).__webglTexture,De,Kt+hn)),P.blitFramebuffer(Ke,dt,Ke+Oe,dt+Ne,Ze,yt,Ze+Oe,yt+Ne,P.DEPTH_BUFFER_BIT,P.NEAREST);ye.bindFramebuffer(P.READ_FRAMEBUFFER,null),ye.bindFramebuffer(P.DRAW_FRAMEBUFFER,null)}else if(Z!==0||w.isRenderTargetTexture||Te.has(w)){let gt=Te.get(w),en=Te.get(z);ye.bindFramebuffer(P.READ_FRAMEBUFFER,D),ye.bindFramebuffer(P.DRAW_FRAMEBUFFER,V);for(let Fn=0;Fn<Be;Fn++)Oi?P.framebufferTextureLayer(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,gt.__webglTexture,Z,xt+Fn):P.framebufferTexture2D(P.READ_FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,gt.__webglTexture,Z),ts?P.framebufferTextureLayer(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,en.__webglTexture,De,Kt+Fn):P.framebufferTexture2D(P.DRAW_FRAMEBUFFER,P.COLOR_ATTACHMENT0,P.TEXTURE_2D,en.__webglTexture,De),Z!==0?P.blitFramebuffer(Ke,dt,Ke+Oe,dt+Ne,Ze,yt,Ze+Oe,yt+Ne,P.COLOR_BUFFER_BIT,P.NEAREST):ts?P.copyTexSubImage3D(We,De,Ze,yt,Kt+Fn,Ke,dt,Oe,Ne):P.copyTexSubImage2D(We,De,Ze,yt,Ke,dt,Oe,Ne);ye.bindFramebuffer(P.READ_FRAMEBUFFER,null),ye.bindFramebuffer(P.DRAW_FRAMEBUFFER,null)}else ts?w.isDataTexture||w.isData3DTexture?P.texSubImage3D(We,De,Ze,yt,Kt,Oe,Ne,Be,Ft,pn,Ot.data):z.isCompressedArrayTexture?P.compressedTexSubImage3D(We,De,Ze,yt,Kt,Oe,Ne,Be,Ft,Ot.data):P.texSubImage3D(We,De,Ze,yt,Kt,Oe,Ne,Be,Ft,pn,Ot):w.isDataTexture?P.texSubImage2D(P.TEXTURE_2D,De,Ze,yt,Oe,Ne,Ft,pn,Ot.data):w.isCompressedTexture?P.compressedTexSubImage2D(P.TEXTURE_2D,De,Ze,yt,Ot.width,Ot.height,Ft,Ot.data):P.texSubImage2D(P.TEXTURE_2D,De,Ze,yt,Oe,Ne,Ft,pn,Ot);ye.pixelStorei(P.UNPACK_ROW_LENGTH,ln),ye.pixelStorei(P.UNPACK_IMAGE_HEIGHT,St),ye.pixelStorei(P.UNPACK_SKIP_PIXELS,es),ye.pixelStorei(P.UNPACK_SKIP_ROWS,cn),ye.pixelStorei(P.UNPACK_SKIP_IMAGES,yr),De===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&P.generateMipmap(We),ye.unbindTexture()},this.initRenderTarget=function(w){Te.get(w).__webglFramebuffer===void 0&&Ge.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Ge.setTextureCube(w,0):w.isData3DTexture?Ge.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Ge.setTexture2DArray(w,0):Ge.setTexture2D(w,0),ye.unbindTexture()},this.resetState=function(){Y=0,H=0,ce=null,ye.reset(),Re.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return gi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Tt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Tt._getUnpackColorSpace()}};function x0(i,e=Math.PI/3){let t=i.index?i.toNonIndexed():i,n=t.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let M=0;M<s;M++)r[3*M+0]=n.getX(M),r[3*M+1]=n.getY(M),r[3*M+2]=n.getZ(M)}let o=Math.cos(e),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let M=0;M<l;M++){let R=9*M,E=r[R+0],y=r[R+1],A=r[R+2],k=r[R+3],U=r[R+4],L=r[R+5],G=r[R+6],X=r[R+7],D=r[R+8],V=G-k,Y=X-U,H=D-L,ce=E-k,q=y-U,j=A-L,ie=Y*j-H*q,pe=H*ce-V*j,he=V*q-Y*ce,ee=1/(Math.sqrt(ie*ie+pe*pe+he*he)||1);c[3*M+0]=ie*ee,c[3*M+1]=pe*ee,c[3*M+2]=he*ee}let h=new Int32Array(s),u=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,g=new Int32Array(d),b=0;for(let M=0;M<s;M++){let R=3*M,E=Math.trunc(r[R+0]*a),y=Math.trunc(r[R+1]*a),A=Math.trunc(r[R+2]*a),k=(Math.imul(E,73856093)^Math.imul(y,19349663)^Math.imul(A,83492791))&f;for(;;){let U=g[k];if(U===0){let G=3*b;u[G+0]=E,u[G+1]=y,u[G+2]=A,g[k]=b+1,h[M]=b++;break}let L=3*(U-1);if(u[L+0]===E&&u[L+1]===y&&u[L+2]===A){h[M]=U-1;break}k=k+1&f}}let p=new Int32Array(b+1);for(let M=0;M<s;M++)p[h[M]+1]++;for(let M=0;M<b;M++)p[M+1]+=p[M];let m=new Int32Array(s),v=p.slice(0,b);for(let M=0;M<l;M++){let R=3*M;m[v[h[R+0]]++]=M,m[v[h[R+1]]++]=M,m[v[h[R+2]]++]=M}let C=new Float32Array(s*3);for(let M=0;M<l;M++){let R=3*M,E=c[R+0],y=c[R+1],A=c[R+2];for(let k=0;k<3;k++){let U=R+k,L=h[U],G=0,X=0,D=0;for(let Y=p[L],H=p[L+1];Y<H;Y++){let ce=3*m[Y],q=c[ce+0],j=c[ce+1],ie=c[ce+2];E*q+y*j+A*ie>o&&(G+=q,X+=j,D+=ie)}let V=1/(Math.sqrt(G*G+X*X+D*D)||1);C[3*U+0]=G*V,C[3*U+1]=X*V,C[3*U+2]=D*V}}return t.setAttribute("normal",new En(C,3,!1)),t}var sT=Math.PI/6;async function qd(i){let e=new DataView((await fl(i.data)).buffer),t=new Float32Array(3*i.points);for(let r=0;r<t.length;++r)t[r]=i.low[r%3]+i.step[r%3]*e.getUint16(2*r,!0);let n=new Uint16Array(3*i.triangles);for(let r=0;r<n.length;++r)n[r]=e.getUint16(2*(t.length+r),!0);let s=new on;return s.setAttribute("position",new En(t,3)),s.setIndex(new En(n,1)),x0(s,sT)}var _i=6;function gh(i,e){let t=i.lengthSq()>0?i.clone().normalize():new F(0,0,1),n=()=>new F(0,0,1).setComponent(2,Math.abs(t.z)>.9?0:1).setComponent(1,Math.abs(t.z)>.9?1:0).cross(t),s=e===null?n():e.clone().addScaledVector(t,-e.dot(t));return s.length()<1e-6&&(s=n()),s.normalize(),[s,new F().crossVectors(t,s),t]}function Ua([i,e,t],n,s){return new bt().makeBasis(i.clone().multiplyScalar(n[0]),e.clone().multiplyScalar(n[1]),t.clone().multiplyScalar(n[2])).setPosition(s)}function y0(i,e,t){let n=e.length,s=new Float32Array(3*_i*n),r=new Float32Array(3*_i*n),o=[],[a,l,c]=[new F,new F,new F];for(let h=0;h<n;++h){a.subVectors(e[Math.min(h+1,n-1)],e[Math.max(h-1,0)]).normalize(),l.addScaledVector(a,-l.dot(a)),l.length()<.001&&l.copy(gh(a,null)[0]),l.normalize(),c.crossVectors(a,l);for(let u=0;u<_i;++u){let[d,f]=[Math.cos(2*Math.PI*u/_i),Math.sin(2*Math.PI*u/_i)],g=3*(h*_i+u);for(let m=0;m<3;++m){let v=d*l.getComponent(m)+f*c.getComponent(m);r[g+m]=v,s[g+m]=e[h].getComponent(m)+t*v}if(h===0)continue;let[b,p]=[(h-1)*_i+u,(h-1)*_i+(u+1)%_i];o.push(b,p,b+_i,p,p+_i,b+_i)}}i.setIndex(o),i.setAttribute("position",new jt(s,3)),i.setAttribute("normal",new jt(r,3)),i.computeBoundingBox(),i.computeBoundingSphere()}var[rT,v0,b0,oT]=[.05,.006,.018,.2],M0="#64748b";function $d(i){return new nt(CSS.supports("color",i.color)?i.color:M0).multiplyScalar(i.shade??1)}function Zd(i,e){let t=new gs({color:$d(i)});i.opacity!==void 0&&Object.assign(t,{transparent:!0,opacity:i.opacity,depthWrite:!1});let n=new an(e,t);return n.matrixAutoUpdate=!1,n}function Rn(i,e,t){let n=t.first+i[e];return new F(t.numbers[n],t.numbers[n+1],t.numbers[n+2])}function S0(i,e,t,n){let[s,r,o]=i.sizes?.[e]??[1,-1,!0];return s*(r<0?1:n.numbers[n.first+r])*(o?t.length:1)}function w0(i,e,t){let{numbers:n}=i,s=Rn(n,"at",t),r="to"in n?Rn(n,"to",t).sub(s):null,o=r??("z"in n?Rn(n,"z",t):new F(0,0,1)),a=[0,1,2].map(c=>S0(i,c,e,t));i.scale?a.fill(o.length()*e.scales[i.scale]):r!==null&&(a[2]=o.length());let l=gh(o,"x"in n?Rn(n,"x",t):null);if(i.still){let c=e.center.clone().sub(s),[h,,u]=l;s.add("x"in n?h.clone().multiplyScalar(c.dot(h)):c.addScaledVector(u,-c.dot(u)))}return s.addScaledVector(l[2],(i.offset??0)*e.length),{axes:l,sizes:a,at:s}}function aT(i,e,t){let n=i.form==="file",s=n?t.meshes[e.mesh??-1]:t.forms.get(i.form??""),r=Zd(i,s??new on);return n&&(r.material.side=Zn),{object:r,update(o){let{axes:a,sizes:l,at:c}=w0(i,t,o);r.matrix.copy(Ua(a,l,c))}}}function lT(i,e,t){let n=Zd(i,new on);n.userData.bent=!0;let s="";return{object:n,update(r){let o=S0(i,2,t,r),a;if(i.form==="coil"){let{axes:l,sizes:c,at:h}=w0(i,t,r);if(n.matrix.copy(Ua(l,[1,1,1],h)),s===`${c}`)return;s=`${c}`,a=t.coil.map(([u,d,f])=>new F(u*c[0],d*c[1],f*c[2]))}else{let l=i.numbers.points;a=Array.from({length:i.count??0},(c,h)=>Rn({at:l+3*h},"at",r))}y0(n.geometry,a,o)}}}function cT(i,e,t){let n=new Un,[s,r]=["cylinder","cone"].map(o=>Zd(i,t.forms.get(o)??new on));return n.add(s,r),{object:n,update(o){let a=Rn(i.numbers,"at",o),l="to"in i.numbers?Rn(i.numbers,"to",o).sub(a):Rn(i.numbers,"vector",o);i.scale?l.multiplyScalar(t.scales[i.scale]):"to"in i.numbers||l.setLength(oT*t.length);let c=l.length();if(n.visible=c>1e-6*t.length,!n.visible)return;let h=Math.min(rT*t.length,.6*c),u=gh(l,null),d=a.clone().addScaledVector(u[2],c-h);s.matrix.copy(Ua(u,[v0*t.length,v0*t.length,c-h],a)),r.matrix.copy(Ua(u,[b0*t.length,b0*t.length,h],d))}}}function hT(i,e,t){let n=new Un,s=new ps(new on,new Fs({color:$d(i)})),r=new ps(s.geometry.clone(),new Fs({color:$d(i),transparent:!0,opacity:.25}));s.frustumCulled=r.frustumCulled=!1,n.add(s,r);let o=null;return{object:n,update(){},follow(a,l){if(a!==o){o=a;let c=new Float32Array(3*a.count),h=t.first+i.numbers.at;for(let u=0;u<a.count;++u)for(let d=0;d<3;++d)c[3*u+d]=a.at(u,h+d);for(let u of[s,r])u.geometry.dispose(),u.geometry=new on,u.geometry.setAttribute("position",new En(c,3))}s.geometry.setDrawRange(0,l+1)}}}function Jd(i,e,t){let n=document.createElement("canvas"),s=n.getContext("2d"),r="48px system-ui, sans-serif";if(s===null)return new Ci;s.font=r,n.width=Math.ceil(s.measureText(i).width)+16,n.height=64,s.font=r,s.fillStyle=t,s.textBaseline="middle",s.fillText(i,8,34);let o=new Ci(new po({map:new ua(n),depthTest:!1}));return o.userData.words=i,o.scale.set(e*n.width/64,e,1),o}function uT(i,e,t){let n=Jd(e.texts.text??e.name,.06*t.length,M0);return{object:n,update:s=>{n.position.copy(Rn(i.numbers,"at",s))}}}var dT={surface:aT,line:lT,arrow:cT,trace:hT,label:uT};function _h(i,e){let t=new Un,[n,s]=[!0,!1].map(o=>i.parts.filter(a=>(a.still??!1)===o).map(a=>{let l=dT[a.primitive](a,i,e);return l.object.traverse(c=>c.userData.part=a),l}));for(let{object:o}of[...n,...s])t.add(o);let r=null;return{object:t,shape:i,update:o=>s.forEach(a=>a.update(o)),follow(o,a){for(let c of s)c.follow?.(o,a);if(o===r)return;r=o;let l=Float64Array.from({length:o.width},(c,h)=>o.at(0,h));for(let c of n)c.update({numbers:l,first:e.first})}}}var R0=[["velocity","v","Velocities of masses"],["acceleration","a","Accelerations of masses"],["admissible","\u2202r/\u2202q","Admissible motions of masses: each coordinate alone"],["reaction","reactions","Forces and torques of joints, rods and wires"],["constraint","constraints","Forces of constraints on masses"],["friction","friction","Dry friction: its forces, and whether it sticks or slides"]],fT={velocity:"m/s",acceleration:"m/s\xB2",reaction:"N","reaction torque":"N\xB7m",constraint:"N",friction:"N",force:"N",torque:"N\xB7m"},T0=["#db2777","#7c3aed","#0891b2","#65a30d","#ca8a04","#dc2626","#2563eb","#0d9488"],A0=.3,pT=.4,Kd=8,E0=1e-10,mT=["open","slides","sticks"],xh=class{constructor(e,t,n){this.vectors=e;this.sizes=t;let s=e.shapes.flatMap(r=>r.texts.coordinate??[]);this.coordinates=[...new Set(s)];for(let r of e.shapes.filter(C0)){let o=this.coordinates.indexOf(r.texts.coordinate??"");if(o>=0)for(let c of r.parts)c.color=T0[o%T0.length];let a=this.scales.get(Oa(r))??{...t,first:e.first,scales:{}};this.scales.set(Oa(r),a);let l=_h(r,a);l.object.traverse(c=>c.userData.shape=r),l.object.visible=!1,this.drawn.push(l),n.add(l.object)}}vectors;sizes;drawn=[];shown=new Set;coordinates;coordinate="";scales=new Map;motion=null;row=0;largest=0;numbers=new Float64Array(0);has(e){return this.vectors.shapes.some(t=>jd(t)===e)}take(e){this.motion=e,this.numbers=new Float64Array(e.width);let t=new Map;for(let n of this.vectors.shapes.filter(C0)){let s=this.vectors.first+n.numbers.vector;for(let r=0;r<e.count;++r){let o=Math.hypot(e.at(r,s),e.at(r,s+1),e.at(r,s+2));Number.isFinite(o)&&t.set(Oa(n),Math.max(t.get(Oa(n))??0,o))}}this.largest=0;for(let n of this.vectors.shapes.filter(({kind:s})=>s==="friction")){let s=this.vectors.first+n.numbers.value;this.largest=Math.max(this.largest,e.largest(s),n.texts.components==="2"?e.largest(s+1):0)}for(let[n,s]of this.scales){let r=t.get(n)??0,o=n.startsWith("reaction torque")?this.sizes.length*(t.get("reaction N")??0):0,a=r>E0*o?A0*this.sizes.length/r:0;s.scales={force:a,torque:pT*a}}}pose(e){if(this.motion!==null&&this.motion.count>0){let n=Math.min(e,this.motion.last);this.motion.state(n,this.numbers),this.row=this.motion.rowAt(n)}let t={numbers:this.numbers,first:this.vectors.first};for(let n of this.drawn){let s=this.coordinate===""||(n.shape.texts.coordinate??this.coordinate)===this.coordinate,r=this.shown.has(jd(n.shape))&&s&&this.motion!==null;n.object.visible=r,r&&n.update(t),n.object.updateMatrixWorld(!0)}}value(e){if(e.kind==="friction")return this.rubs(e);let t=Rn(e.numbers,"vector",{numbers:this.numbers,first:this.vectors.first});return`${Fa(t.length())} ${vs(e)}`}legend(){let e=[],t=[];for(let[o,a]of this.scales){let l=this.vectors.shapes.find(u=>Oa(u)===o);if(l===void 0||!this.shown.has(jd(l))||a.scales.force===0)continue;let c=vs(l)==="1"?"":` ${vs(l)}`,h=`${Fa(A0*this.sizes.length/a.scales.force)}${c}`;l.kind==="admissible"?t.push(...this.movedIn(vs(l)).map(u=>`\u2202r/\u2202${sm(u)}: ${h}`)):e.push(`${l.kind}: longest ${h}`)}if(t.length>0&&e.unshift(`longest ${t.join(", ")}`),!this.shown.has("friction")||this.motion===null)return e;let s=[...new Map(this.vectors.shapes.filter(({kind:o})=>o==="friction").map(o=>[o.name,o])).values()].map(o=>`${o.name}: ${this.rubs(o)}`),r=s.length>Kd?[`and ${s.length-Kd} more`]:[];return[...e,...s.slice(0,Kd),...r]}movedIn(e){let t=this.vectors.shapes.filter(s=>s.kind==="admissible"&&vs(s)===e);return[...new Set(t.flatMap(s=>s.texts.coordinate??[]))].filter(s=>this.coordinate===""||s===this.coordinate)}rubs(e){let{first:t}=this.vectors,n=mT[this.motion?.at(this.row,t+e.numbers.mode)??0]??"";if(n==="open")return n;let s=t+e.numbers.value,r=Math.hypot(...this.numbers.subarray(s,s+Number(e.texts.components)));return`${n}, ${Fa(r>E0*this.largest?r:0)} ${vs(e)}`}};function C0(i){return"vector"in i.numbers}function vs(i){return i.texts.unit??fT[i.kind]??""}function Fa(i){return Number(i.toPrecision(3)).toString()}function jd(i){return i.kind==="reaction torque"?"reaction":i.kind}function Oa(i){return`${i.kind} ${vs(i)}`}var gT=[.1,.25,.5,1,2,4],_T=[1,60],xT=5;function yT(i){let[e,t]=_T;return i>=e&&i<=t?1:Number(Fr(i/xT).toPrecision(1))}var yh=class{constructor(e,t,n){this.moved=n;this.time=e.start,this.span=[e.start,e.stop],this.again=e.modes!==void 0,this.speed=this.again?1:yT(e.stop-e.start);let s=this.speed===1?gT:[...[.1,.2,.5,1,2,5].map(l=>l*this.speed),1];this.choices=[...new Set(s.map(l=>Number(l.toPrecision(3))))].sort((l,c)=>l-c),this.button=et("button",{className:"play",onclick:()=>this.toggle()});let{start:r,stop:o}=e;this.bar=et("input",{type:"range",min:`${r}`,max:`${o}`,step:"any",value:`${r}`,ariaLabel:"Time"}),this.bar.oninput=()=>this.go(Number(this.bar.value)),this.clock=et("output",{className:"clock"}),this.ticks=et("div",{className:"ticks",ariaHidden:"true"});let a=et("div",{className:"track"},this.ticks,this.bar);this.chooser=this.speeds(),t.append(this.button,a,this.clock,this.chooser),this.mark(e.events),this.show()}moved;time;speed;choices;pace=1;span;again;running=!1;before=0;bar;button;clock;ticks;chooser;over(e,t,n){let[s,r]=this.span,o=(this.time-s)/(r-s||1),a=s===e&&r===t;this.span=[e,t],this.pace=n,Object.assign(this.bar,{min:`${e}`,max:`${t}`}),a||(this.time=e+o*(t-e)),this.show()}faster(e){let t=Math.min(Math.max(this.choices.indexOf(this.speed)+e,0),this.choices.length-1);this.speed=this.choices[t],this.chooser.value=`${this.speed}`}speeds(){let e=et("select",{ariaLabel:"Speed"});for(let t of this.choices)e.append(new Option(`${t}\xD7`,`${t}`,t===this.speed,t===this.speed));return e.onchange=()=>this.speed=Number(e.value),e}mark(e){let[t,n]=this.span,s=ol(e,t,n).map(({time:o,name:a,kind:l})=>{let c=et("i",{title:`${a} ${l}`,className:l});return c.style.left=`${100*(o-t)/(n-t)}%`,c}),r=al(e,t,n).map(o=>et("b",{style:`opacity: ${.5*o}`}));this.ticks.replaceChildren(...r,...s)}toggle(){this.running?this.pause():this.play()}play(){this.time>=this.span[1]&&([this.time]=this.span),this.running=!0,this.before=performance.now(),requestAnimationFrame(e=>this.tick(e)),this.show()}pause(){this.running=!1,this.show()}go(e){this.time=Math.min(Math.max(e,this.span[0]),this.span[1]),this.show(),this.moved(this.time)}step(e){this.pause(),this.go(this.time+e*(this.span[1]-this.span[0]))}get digits(){return Math.min(Math.max(2-Math.floor(Math.log10((this.span[1]-this.span[0])/2)),2),9)}tick(e){if(!this.running)return;let t=this.time+(e-this.before)/1e3*this.speed*this.pace;if(this.before=e,t>=this.span[1]&&!this.again){this.go(this.span[1]),this.pause();return}this.go(t>=this.span[1]?this.span[0]:t),requestAnimationFrame(n=>this.tick(n))}show(){this.button.textContent=this.running?"\u275A\u275A":"\u25B6",this.button.setAttribute("aria-label",this.running?"Pause":"Play"),this.bar.value=`${this.time}`,this.clock.value=`${this.time.toFixed(this.digits)} s`}};var bs={left:62,right:10,top:8,bottom:34},vT="http://www.w3.org/2000/svg";function I0(i){let e=document.createElement("div");e.className="locus";let t=i.unit&&i.unit!=="1"?` [${i.unit}]`:"",[n,s]=[Math.min(...i.values),Math.max(...i.values)],r=(l,c)=>i.values.flatMap((h,u)=>i.eigenvalues[u].flatMap(d=>d===null?[]:[{x:l(h,d),y:c(d),part:(h-n)/(s-n||1),words:`${i.name} = ${h.toPrecision(4)}`}])),o=i.thresholds.map(l=>l.value);e.append(Qd(r((l,c)=>c[0],l=>l[1]),"real part [1/s]","imaginary part [1/s]",[],!0),Qd(r(l=>l,l=>l[0]),`${i.name}${t}`,"real part [1/s]",o,!1),Qd(r(l=>l,l=>Math.abs(l[1])/(2*Math.PI)),`${i.name}${t}`,"frequency [Hz]",o,!1));let a=document.createElement("ul");for(let{value:l,kind:c,frequency:h,unstable_above:u}of i.thresholds){let d=document.createElement("li"),f=h>0?` at ${h.toPrecision(4)} Hz`:"";d.textContent=`${c}${f} ${u?"above":"below"} ${i.name} = ${l.toPrecision(6)} ${i.unit}`,a.append(d)}return i.thresholds.length>0&&e.append(a),e}function mr(i,e,t=""){let n=document.createElementNS(vT,i);for(let[s,r]of Object.entries(e))n.setAttribute(s,`${r}`);return t!==""&&(n.textContent=t),n}function P0(i){let[e,t]=[Math.min(...i),Math.max(...i)],n=t>e?.06*(t-e):1;return[e-n,t+n]}function Qd(i,e,t,n,s){let r=mr("svg",{viewBox:"0 0 420 200",role:"img","aria-label":`${t} over ${e}`}),[o,a]=P0([...i.map(g=>g.x),...s?[0]:[]]),[l,c]=P0([...i.map(g=>g.y),0]),h=g=>bs.left+(g-o)/(a-o)*(420-bs.left-bs.right),u=g=>200-bs.bottom-(g-l)/(c-l)*(200-bs.top-bs.bottom),d=(g,b,p)=>{r.append(mr("line",{x1:g[0],y1:g[1],x2:b[0],y2:b[1],class:p}))};d([h(o),u(0)],[h(a),u(0)],"axis"),s&&d([h(0),u(l)],[h(0),u(c)],"axis");for(let g of n)d([h(g),u(l)],[h(g),u(c)],"threshold");for(let g of i){let b=mr("circle",{cx:h(g.x).toFixed(2),cy:u(g.y).toFixed(2),r:2,fill:`hsl(${(230-190*g.part).toFixed(0)} 70% 50%)`});b.append(mr("title",{},g.words)),r.append(b)}let f=[[h(o),180,"start",o.toPrecision(3)],[h(a),180,"end",a.toPrecision(3)],[bs.left-4,u(l),"end",l.toPrecision(3)],[bs.left-4,u(c)+9,"end",c.toPrecision(3)]];for(let[g,b,p,m]of f)r.append(mr("text",{x:g,y:b,"text-anchor":p},m));return r.append(mr("text",{x:(bs.left+420)/2,y:194,"text-anchor":"middle"},e)),r.append(mr("text",{x:-200/2+10,y:12,"text-anchor":"middle",transform:"rotate(-90)"},t)),r}var vh=class{constructor(e,t,n){this.head=e;this.chosen=n;let s=et("section",{id:"runs"});e.modes!==void 0?this.modes(s,e.modes):e.runs!==void 0&&e.runs.length>1&&this.sweep(s,e.runs.map(r=>r.label)),t.prepend(s)}head;chosen;level=0;mode=0;buttons=[];sweep(e,t){let n=et("input",{type:"range",min:"0",max:`${t.length-1}`,step:"1",value:"0",ariaLabel:"Run"}),s=et("output"),r=()=>{let o=Number(n.value);s.textContent=`Run ${o+1} of ${t.length}: ${t[o]}`,n.ariaValueText=s.textContent};n.oninput=()=>{r(),this.chosen(Number(n.value))},r(),e.append(et("label",{},s,n))}modes(e,t){let n=this.head.levels??[""];this.level=Math.min(1,n.length-1);let s=et("p",{textContent:this.head.stability??""}),r=et("div",{className:"modes"});t.forEach((l,c)=>{let h=et("button",{textContent:`${c+1}: ${bT(l)}`});h.onclick=()=>{this.mode=c,this.show(t,a)},this.buttons.push(h),r.append(h)});let o=et("select",{ariaLabel:"Amplitude"});n.forEach((l,c)=>o.append(new Option(`amplitude: ${l}`,`${c}`,c===this.level,c===this.level))),o.onchange=()=>{this.level=Number(o.value),this.show(t,a)};let a=et("table",{className:"shape"});e.append(s,r,o,a),this.head.locus!=null&&e.append(I0(this.head.locus)),this.show(t,a)}get run(){return this.mode*(this.head.levels?.length??1)+this.level}show(e,t){this.buttons.forEach((r,o)=>r.ariaPressed=`${o===this.mode}`);let n=et("tr",{},...["shape","size","phase"].map(r=>et("th",{scope:"col",textContent:r}))),s=e[this.mode].shape.map(({name:r,size:o,phase:a})=>{let l=[r,o.toPrecision(3),o>1e-9?`${a.toFixed(0)}\xB0`:""];return et("tr",{},...l.map(c=>et("td",{textContent:c})))});t.replaceChildren(n,...s),this.chosen(this.run)}};function bT(i){let[e]=i.eigenvalue,t=i.frequency>0?[`${i.frequency.toPrecision(4)} Hz`]:[`${e.toPrecision(4)} 1/s`];return i.frequency>0&&i.damping!==null&&Math.abs(i.damping)>1e-7&&t.push(`damping ${i.damping.toPrecision(3)}`),i.constant!==null&&t.push(`${i.constant>0?"falls":"grows"} in ${Math.abs(i.constant).toPrecision(3)} s`),t.join(", ")}var MT=1e-12,ST=12;function wT(i){return i.group==="parameter"||i.kind!=="Real"}function L0({minimum:i,maximum:e,display:t},n){let s=r=>Math.abs(n-r)<=MT*(Math.abs(r)+Math.abs(t.shift/t.scale));return[i,e].find(r=>r!==null&&s(r))??n}function TT(i,e){let{minimum:t,maximum:n}=i;if(Number.isNaN(e))return"this is no number";let s=bh(i,e);return Number.isFinite(e)?i.kind!=="Real"&&!Number.isSafeInteger(e)?`${s} is no whole number below 2^53`:t!==null&&e<t?`${s} is below min = ${bh(i,t)}`:n!==null&&e>n?`${s} is above max = ${bh(i,n)}`:"":`${s} is not finite`}function ef(i,e,t){let n=TT(i,e),s=Number.isFinite(e)&&(n===""||!wT(i));return n===""?{taken:s,words:n}:{taken:s,words:s?`${n}; the run takes it`:`${n}; the value stays ${bh(i,t)}`}}function bh({display:i},e){return`${Hi(e*i.scale+i.shift,ST)} ${i.unit}`.trim()}var AT=[["start","More start values"],["parameter","More parameters"],["input","More inputs"]],tf=1e3;function ET(i,e){let{minimum:t,maximum:n,display:s}=i,r=Math.min(Math.max(i.value,t??-1/0),n??1/0),[o,a]=r===0?[-1,1]:[r/Math.sqrt(10),r*Math.sqrt(10)];if(i.angle)[o,a]=[Math.min(-Math.PI,r),Math.max(Math.PI,r)];else if(i.group!=="parameter"){let l=Fr((Math.max(2*Math.abs(r),e)||1)*s.scale)/s.scale;[o,a]=[-l,l]}return o>a&&([o,a]=[a,o]),[t??o,n??a]}function nf(i,e){return Hi(e*i.display.scale+i.display.shift,4)}function CT(i){return i.split(/(?<=[._])|(?=\[)/).flatMap(e=>[e,et("wbr")])}var Mh=class{constructor(e,t,n,s){this.head=e;this.motion=t;this.place=n;this.changed=s;this.values=new Map([...e.parameters,...e.inputs].map(a=>[a,a.value]));let r=e.sliders.flatMap(a=>[...this.values.keys()].filter(l=>l.name===a));n.append(...r.map(a=>this.row(a)));for(let[a,l]of AT){let c=[...this.values.keys()].filter(u=>u.group===a&&!r.includes(u));if(c.length===0)continue;let h=r.length===0;n.append(et("details",{open:h},et("summary",{textContent:l}),...c.map(u=>this.row(u))))}let o=()=>{for(let a of this.values.keys())this.values.set(a,a.value);this.reread(),s()};n.append(et("button",{textContent:"Reset all",onclick:o}))}head;motion;place;changed;values;put(e,t){let n=[...this.values.keys()].find(s=>s.name===e);n!==void 0&&this.values.set(n,t),this.reread()}set(e,t){let n=this.head.parameters.find(s=>s.name===e);n!==void 0&&(this.put(e,t(this.values.get(n)??n.value)),this.changed())}reread(){this.place.querySelectorAll("input").forEach(e=>e.dispatchEvent(new Event("reread")))}get parameters(){return Float64Array.from(this.head.parameters,e=>this.values.get(e)??e.value)}get inputs(){return Float64Array.from(this.head.inputs,e=>this.values.get(e)??e.value)}take(e){this.head.parameters.forEach((t,n)=>this.values.set(t,e[n])),this.reread()}largest(e){let t=this.head.columns.find(o=>o.name===e),n=this.head.columns.map((o,a)=>t!==void 0&&o.kind===t.kind&&o.unit===t.unit?this.motion.largest(a):0),[s,r]=[t===void 0?0:n[this.head.columns.indexOf(t)],Math.max(...n)];return s>1e-9*r?s:r}row(e){let t=e.group==="start"?e.name.replace(/\.start$/,""):e.name,[n,s]=ET(e,e.group==="start"?this.largest(t):0),r=e.kind!=="Real",{unit:o}=e.display,a=et("input",{type:"range",min:"0",max:`${tf}`,step:r?"any":"1",ariaLabel:e.name}),l=et("input",{type:"number",step:"any",ariaLabel:`${e.name} in ${o||"SI units"}`}),c=et("span",{className:"fault",ariaLive:"polite"}),h=p=>{c.textContent=p,c.hidden=p==="",l.setAttribute("aria-invalid",`${p!==""}`)},u=()=>this.values.get(e)??e.value,d=()=>{let p=u();a.value=`${tf*(p-n)/(s-n||1)}`,l.value=nf(e,p),h(ef(e,p,p).words)},f=p=>{let m=L0(e,p),{taken:v,words:C}=ef(e,m,u());v&&(this.values.set(e,m),this.changed()),d(),h(C)};a.oninput=()=>{let p=n+(s-n)*Number(a.value)/tf;f(r?Math.round(p):p)},l.onchange=()=>f((l.valueAsNumber-e.display.shift)/e.display.scale),a.addEventListener("reread",d);let g=et("span",{},...CT(t)),b=et("label",{title:e.doc??""},g,a,l,et("span",{className:"unit",textContent:o}),c);return b.ondblclick=()=>f(e.value),d(),b}};function RT(i,e){return i===""?["\u200B"]:[...e.slice(0,i.length).matchAll(/(.)\1*/gs)].map(({index:t,0:n,1:s})=>et("span",{className:`ink-${s}`,textContent:i.slice(t,t+n.length)}))}var Sh=class{lines;pinned=[];constructor(e,t,n,s){let r=0;this.lines=e.source.split(`
`).map((o,a)=>{let l=et("div",{className:"line"},...RT(o,e.inks.slice(r,r+=o.length+1)));l.dataset.number=`${a+1}`;let c={first:[a+1,1],last:[a+2,1]};return l.onpointerenter=()=>n(c),l.onpointerleave=()=>n(null),l.onclick=()=>s(c),l}),t.append(...this.lines)}pin(e){this.pinned=e,this.mark(e)}mark(e){this.lines.forEach((t,n)=>{t.classList.toggle("marked",[...e,...this.pinned].some(s=>n+1>=s.first[0]&&n+1<=s.last[0]))}),e.length>0&&this.lines[e[0].first[0]-1]?.scrollIntoView({block:"nearest"})}};var D0={type:"change"},rf={type:"start"},U0={type:"end"},wh=new Os,N0=new Wn,PT=Math.cos(70*hh.DEG2RAD),bn=new F,jn=2*Math.PI,It={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},sf=1e-6,Th=class extends ba{constructor(e,t=null){super(e,t),this.state=It.NONE,this.target=new F,this.cursor=new F,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Gs.ROTATE,MIDDLE:Gs.DOLLY,RIGHT:Gs.PAN},this.touches={ONE:Hs.ROTATE,TWO:Hs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new F,this._lastQuaternion=new li,this._lastTargetPosition=new F,this._quat=new li().setFromUnitVectors(e.up,new F(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new yo,this._sphericalDelta=new yo,this._scale=1,this._panOffset=new F,this._rotateStart=new qe,this._rotateEnd=new qe,this._rotateDelta=new qe,this._panStart=new qe,this._panEnd=new qe,this._panDelta=new qe,this._dollyStart=new qe,this._dollyEnd=new qe,this._dollyDelta=new qe,this._dollyDirection=new F,this._mouse=new qe,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=LT.bind(this),this._onPointerDown=IT.bind(this),this._onPointerUp=DT.bind(this),this._onContextMenu=kT.bind(this),this._onMouseWheel=OT.bind(this),this._onKeyDown=FT.bind(this),this._onTouchStart=BT.bind(this),this._onTouchMove=zT.bind(this),this._onMouseDown=NT.bind(this),this._onMouseMove=UT.bind(this),this._interceptControlDown=GT.bind(this),this._interceptControlUp=HT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=It.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(D0),this.update(),this.state=It.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;bn.copy(t).sub(this.target),bn.applyQuaternion(this._quat),this._spherical.setFromVector3(bn),this.autoRotate&&this.state===It.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=jn:n>Math.PI&&(n-=jn),s<-Math.PI?s+=jn:s>Math.PI&&(s-=jn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(bn.setFromSpherical(this._spherical),bn.applyQuaternion(this._quatInverse),t.copy(this.target).add(bn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=bn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new F(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new F(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=bn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(wh.origin.copy(this.object.position),wh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(wh.direction))<PT?this.object.lookAt(this.target):(N0.setFromNormalAndCoplanarPoint(this.object.up,this.target),wh.intersectPlane(N0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>sf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>sf||this._lastTargetPosition.distanceToSquared(this.target)>sf?(this.dispatchEvent(D0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?jn/60*this.autoRotateSpeed*e:jn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){bn.setFromMatrixColumn(t,0),bn.multiplyScalar(-e),this._panOffset.add(bn)}_panUp(e,t){this.screenSpacePanning===!0?bn.setFromMatrixColumn(t,1):(bn.setFromMatrixColumn(t,0),bn.crossVectors(this.object.up,bn)),bn.multiplyScalar(e),this._panOffset.add(bn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;bn.copy(s).sub(this.target);let r=bn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/t.clientHeight),this._rotateUp(jn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-jn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(jn*this._rotateDelta.x/t.clientHeight),this._rotateUp(jn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new qe,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function IT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function LT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function DT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(U0),this.state=It.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function NT(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Gs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=It.DOLLY;break;case Gs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}break;case Gs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(rf)}function UT(i){switch(this.state){case It.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case It.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case It.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function OT(i){this.enabled===!1||this.enableZoom===!1||this.state!==It.NONE||(i.preventDefault(),this.dispatchEvent(rf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(U0))}function FT(i){this.enabled!==!1&&this._handleKeyDown(i)}function BT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Hs.ROTATE:if(this.enableRotate===!1){this.state=It.NONE;break}this._handleTouchStartRotate(i),this.state=It.TOUCH_ROTATE;break;case Hs.PAN:if(this.enablePan===!1){this.state=It.NONE;break}this._handleTouchStartPan(i),this.state=It.TOUCH_PAN;break;default:this.state=It.NONE}break;case 2:switch(this.touches.TWO){case Hs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=It.TOUCH_DOLLY_PAN;break;case Hs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=It.TOUCH_DOLLY_ROTATE;break;default:this.state=It.NONE}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(rf)}function zT(i){switch(this._trackPointer(i),this.state){case It.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case It.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case It.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case It.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=It.NONE}}function kT(i){this.enabled!==!1&&i.preventDefault()}function GT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function HT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Ah(i,e){return new an(e,new gs({color:i}))}function O0(i,e,t,n,s,r){let o=.16*e.length,a=new F().setFromMatrixColumn(n,0),l=new F().setFromMatrixColumn(n,1),c=new Un;c.quaternion.setFromRotationMatrix(n);let h=t.getCenter(new F),u=Math.min(l.dot(t.min),l.dot(t.max))-l.dot(h);c.position.copy(h).addScaledVector(l,u-1.7*o),c.position.addScaledVector(a,(s-(r-1)/2)*2.6*o);let d=Jd(i.name,.4*o,"#64748b");d.position.set(0,-1.3*o,0),c.add(d);let f=m=>m.numbers[m.first+i.numbers.value];if(i.kind==="dial"){let m=Ah(2450411,new qi(.12*o,o,.12*o));return m.geometry.translate(0,.5*o,0),c.add(Ah(9741240,new pa(o,.05*o,12,64)),m),{object:c,shape:i,update:v=>{m.rotation.set(0,0,f(v))}}}let g=Ah(2450411,new qi(.5*o,.5*o,.5*o));c.add(Ah(9741240,new qi(2.2*o,.06*o,.06*o)),g);let b=null,p=1;return{object:c,shape:i,update:m=>{g.position.x=.85*o*f(m)/p},follow(m){m!==b&&(b=m,p=Math.max(m.largest(e.first+i.numbers.value),1e-12))}}}var of=class{constructor(){this.id=0,this.object=null,this.z=0,this.renderOrder=0}},Ba=class{constructor(){this.id=0,this.v1=new Ms,this.v2=new Ms,this.v3=new Ms,this.normalModel=new F,this.vertexNormalsModel=[new F,new F,new F],this.vertexNormalsLength=0,this.color=new nt,this.material=null,this.uvs=[new qe,new qe,new qe],this.z=0,this.renderOrder=0}},Ms=class{constructor(){this.position=new F,this.positionWorld=new F,this.positionScreen=new Ct,this.visible=!0}copy(e){this.positionWorld.copy(e.positionWorld),this.positionScreen.copy(e.positionScreen)}},za=class{constructor(){this.id=0,this.v1=new Ms,this.v2=new Ms,this.vertexColors=[new nt,new nt],this.material=null,this.z=0,this.renderOrder=0}},ka=class{constructor(){this.id=0,this.object=null,this.x=0,this.y=0,this.z=0,this.rotation=0,this.scale=new qe,this.material=null,this.renderOrder=0}},Eh=class{constructor(){let e,t,n=0,s,r,o=0,a,l,c=0,h,u,d=0,f,g,b=0,p,m=[],v=[],C={objects:[],lights:[],elements:[]},M=new F,R=new Ct,E=new Jn(new F(-1,-1,-1),new F(1,1,1)),y=new Jn,A=new Array(3),k=new bt,U=new bt,L=new bt,G=new Yi,X=[],D=[],V=[],Y=[],H=[],ce=[],q=new Ct,j=new Ct,ie=new Ct,pe=[],he=[null,null,null],ee=[{sign:1},{sign:-1}];function ge(){let K=[],de=[],xe=[],Se=null,_e=new at;function $e(x){Se=x,_e.getNormalMatrix(Se.matrixWorld),K.length=0,de.length=0,xe.length=0}function P(x){let B=x.position,se=x.positionWorld,Q=x.positionScreen;se.copy(B).applyMatrix4(p),Q.copy(se).applyMatrix4(U);let me=1/Q.w;Q.x*=me,Q.y*=me,Q.z*=me,x.visible=Q.x>=-1&&Q.x<=1&&Q.y>=-1&&Q.y<=1&&Q.z>=-1&&Q.z<=1}function ue(x,B,se){s=Je(),s.position.set(x,B,se),P(s)}function ke(x,B,se){K.push(x,B,se)}function Ue(x,B,se){de.push(x,B,se)}function ye(x,B){xe.push(x,B)}function Xe(x,B,se){return x.visible===!0||B.visible===!0||se.visible===!0?!0:(A[0]=x.positionScreen,A[1]=B.positionScreen,A[2]=se.positionScreen,E.intersectsBox(y.setFromPoints(A)))}function Te(x,B,se){return(se.positionScreen.x-x.positionScreen.x)*(B.positionScreen.y-x.positionScreen.y)-(se.positionScreen.y-x.positionScreen.y)*(B.positionScreen.x-x.positionScreen.x)<0}function Ge(x,B){let se=D[x],Q=D[B];se.positionScreen.copy(se.position).applyMatrix4(L),Q.positionScreen.copy(Q.position).applyMatrix4(L),Wt(se.positionScreen,Q.positionScreen)===!0&&(se.positionScreen.multiplyScalar(1/se.positionScreen.w),Q.positionScreen.multiplyScalar(1/Q.positionScreen.w),h=pt(),h.id=Se.id,h.v1.copy(se),h.v2.copy(Q),h.z=Math.max(se.positionScreen.z,Q.positionScreen.z),h.renderOrder=Se.renderOrder,h.material=Se.material,Se.material.vertexColors&&(h.vertexColors[0].fromArray(de,x*3),h.vertexColors[1].fromArray(de,B*3)),C.elements.push(h))}function T(x,B,se,Q){let me=D[x],ve=D[B],te=D[se],re=me.positionScreen.w,be=ve.positionScreen.w,O=te.positionScreen.w,ae=re*(me.positionScreen.z+1),oe=be*(ve.positionScreen.z+1),Pe=O*(te.positionScreen.z+1),Ae=re*(1-me.positionScreen.z),Re=be*(1-ve.positionScreen.z),Qe=O*(1-te.positionScreen.z);if(ae<0&&oe<0&&Pe<0||Ae<0&&Re<0&&Qe<0)return;if(ae>=0&&oe>=0&&Pe>=0&&Ae>=0&&Re>=0&&Qe>=0){if(Xe(me,ve,te)===!1)return;if(Q.side===Zn||Te(me,ve,te)===!0){a=ft(),a.id=Se.id,a.v1.copy(me),a.v2.copy(ve),a.v3.copy(te),a.z=(me.positionScreen.z+ve.positionScreen.z+te.positionScreen.z)/3,a.renderOrder=Se.renderOrder,M.subVectors(te.position,ve.position),R.subVectors(me.position,ve.position),M.cross(R),a.normalModel.copy(M),a.normalModel.applyMatrix3(_e).normalize();for(let le=0;le<3;le++){let Fe=a.vertexNormalsModel[le];Fe.fromArray(K,arguments[le]*3),Fe.applyMatrix3(_e).normalize(),a.uvs[le].fromArray(xe,arguments[le]*2)}a.vertexNormalsLength=3,a.material=Q,Q.vertexColors&&a.color.fromArray(de,x*3),C.elements.push(a)}return}q.set(me.positionScreen.x*re,me.positionScreen.y*re,me.positionScreen.z*re,re),j.set(ve.positionScreen.x*be,ve.positionScreen.y*be,ve.positionScreen.z*be,be),ie.set(te.positionScreen.x*O,te.positionScreen.y*O,te.positionScreen.z*O,O),he[0]=q,he[1]=j,he[2]=ie;let st=Lt(he);if(!(st<3)){for(let le=0;le<st;le++){let Fe=m[le],tt=pe[le];tt||(tt=new Ms,pe[le]=tt);let Ce=1/Fe.w;tt.positionScreen.set(Fe.x*Ce,Fe.y*Ce,Fe.z*Ce,1),tt.positionWorld.copy(me.positionWorld),tt.visible=!0}for(let le=1;le<st-1;le++){let Fe=pe[0],tt=pe[le],Ce=pe[le+1];if(Q.side===Zn||Te(Fe,tt,Ce)===!0){a=ft(),a.id=Se.id,a.v1.copy(Fe),a.v2.copy(tt),a.v3.copy(Ce),a.z=(Fe.positionScreen.z+tt.positionScreen.z+Ce.positionScreen.z)/3,a.renderOrder=Se.renderOrder,M.subVectors(te.position,ve.position),R.subVectors(me.position,ve.position),M.cross(R),a.normalModel.copy(M),a.normalModel.applyMatrix3(_e).normalize();for(let lt=0;lt<3;lt++){let zt=a.vertexNormalsModel[lt];zt.fromArray(K,arguments[lt]*3),zt.applyMatrix3(_e).normalize(),a.uvs[lt].fromArray(xe,arguments[lt]*2)}a.vertexNormalsLength=3,a.material=Q,Q.vertexColors&&a.color.fromArray(de,x*3),C.elements.push(a)}}}}return{setObject:$e,projectVertex:P,checkTriangleVisibility:Xe,checkBackfaceCulling:Te,pushVertex:ue,pushNormal:ke,pushColor:Ue,pushUv:ye,pushLine:Ge,pushTriangle:T}}let Me=new ge;function Le(K){if(K.visible===!1)return;if(K.isLight)C.lights.push(K);else if(K.isMesh||K.isLine||K.isPoints){if(K.material.visible===!1||K.frustumCulled===!0&&G.intersectsObject(K)===!1)return;Ee(K)}else if(K.isSprite){if(K.material.visible===!1||K.frustumCulled===!0&&G.intersectsSprite(K)===!1)return;Ee(K)}let de=K.children;for(let xe=0,Se=de.length;xe<Se;xe++)Le(de[xe])}function Ee(K){e=ut(),e.id=K.id,e.object=K,M.setFromMatrixPosition(K.matrixWorld),M.applyMatrix4(U),e.z=M.z,e.renderOrder=K.renderOrder,C.objects.push(e)}this.projectScene=function(K,de,xe,Se){l=0,u=0,g=0,C.elements.length=0,K.matrixWorldAutoUpdate===!0&&K.updateMatrixWorld(),de.parent===null&&de.matrixWorldAutoUpdate===!0&&de.updateMatrixWorld(),k.copy(de.matrixWorldInverse),U.multiplyMatrices(de.projectionMatrix,k),G.setFromProjectionMatrix(U),t=0,C.objects.length=0,C.lights.length=0,Le(K),xe===!0&&C.objects.sort(Ut);let _e=C.objects;for(let $e=0,P=_e.length;$e<P;$e++){let ue=_e[$e].object,ke=ue.geometry;if(Me.setObject(ue),p=ue.matrixWorld,r=0,ue.isMesh){let Ue=ue.material,ye=Array.isArray(Ue),Xe=ke.attributes,Te=ke.groups;if(Xe.position===void 0)continue;let Ge=Xe.position.array;for(let T=0,x=Ge.length;T<x;T+=3){let B=Ge[T],se=Ge[T+1],Q=Ge[T+2],me=ke.morphAttributes.position;if(me!==void 0){let ve=ke.morphTargetsRelative,te=ue.morphTargetInfluences;for(let re=0,be=me.length;re<be;re++){let O=te[re];if(O===0)continue;let ae=me[re];ve?(B+=ae.getX(T/3)*O,se+=ae.getY(T/3)*O,Q+=ae.getZ(T/3)*O):(B+=(ae.getX(T/3)-Ge[T])*O,se+=(ae.getY(T/3)-Ge[T+1])*O,Q+=(ae.getZ(T/3)-Ge[T+2])*O)}}Me.pushVertex(B,se,Q)}if(Xe.normal!==void 0){let T=Xe.normal.array;for(let x=0,B=T.length;x<B;x+=3)Me.pushNormal(T[x],T[x+1],T[x+2])}if(Xe.color!==void 0){let T=Xe.color.array;for(let x=0,B=T.length;x<B;x+=3)Me.pushColor(T[x],T[x+1],T[x+2])}if(Xe.uv!==void 0){let T=Xe.uv.array;for(let x=0,B=T.length;x<B;x+=2)Me.pushUv(T[x],T[x+1])}if(ke.index!==null){let T=ke.index.array;if(Te.length>0)for(let x=0;x<Te.length;x++){let B=Te[x];if(Ue=ye===!0?ue.material[B.materialIndex]:ue.material,Ue!==void 0)for(let se=B.start,Q=B.start+B.count;se<Q;se+=3)Me.pushTriangle(T[se],T[se+1],T[se+2],Ue)}else for(let x=0,B=T.length;x<B;x+=3)Me.pushTriangle(T[x],T[x+1],T[x+2],Ue)}else if(Te.length>0)for(let T=0;T<Te.length;T++){let x=Te[T];if(Ue=ye===!0?ue.material[x.materialIndex]:ue.material,Ue!==void 0)for(let B=x.start,se=x.start+x.count;B<se;B+=3)Me.pushTriangle(B,B+1,B+2,Ue)}else for(let T=0,x=Ge.length/3;T<x;T+=3)Me.pushTriangle(T,T+1,T+2,Ue)}else if(ue.isLine){L.multiplyMatrices(U,p);let Ue=ke.attributes;if(Ue.position!==void 0){let ye=Ue.position.array;for(let Xe=0,Te=ye.length;Xe<Te;Xe+=3)Me.pushVertex(ye[Xe],ye[Xe+1],ye[Xe+2]);if(Ue.color!==void 0){let Xe=Ue.color.array;for(let Te=0,Ge=Xe.length;Te<Ge;Te+=3)Me.pushColor(Xe[Te],Xe[Te+1],Xe[Te+2])}if(ke.index!==null){let Xe=ke.index.array;for(let Te=0,Ge=Xe.length;Te<Ge;Te+=2)Me.pushLine(Xe[Te],Xe[Te+1])}else{let Xe=ue.isLineSegments?2:1;for(let Te=0,Ge=ye.length/3-1;Te<Ge;Te+=Xe)Me.pushLine(Te,Te+1)}}}else if(ue.isPoints){L.multiplyMatrices(U,p);let Ue=ke.attributes;if(Ue.position!==void 0){let ye=Ue.position.array;for(let Xe=0,Te=ye.length;Xe<Te;Xe+=3)R.set(ye[Xe],ye[Xe+1],ye[Xe+2],1),R.applyMatrix4(L),je(R,ue,de)}}else ue.isSprite&&(ue.modelViewMatrix.multiplyMatrices(de.matrixWorldInverse,ue.matrixWorld),R.set(p.elements[12],p.elements[13],p.elements[14],1),R.applyMatrix4(U),je(R,ue,de))}return Se===!0&&C.elements.sort(Ut),C};function je(K,de,xe){let Se=1/K.w;K.z*=Se,K.z>=-1&&K.z<=1&&(f=ot(),f.id=de.id,f.x=K.x*Se,f.y=K.y*Se,f.z=K.z,f.renderOrder=de.renderOrder,f.object=de,f.rotation=de.rotation,f.scale.x=de.scale.x*Math.abs(f.x-(K.x+xe.projectionMatrix.elements[0])/(K.w+xe.projectionMatrix.elements[12])),f.scale.y=de.scale.y*Math.abs(f.y-(K.y+xe.projectionMatrix.elements[5])/(K.w+xe.projectionMatrix.elements[13])),f.material=de.material,C.elements.push(f))}function ut(){if(t===n){let K=new of;return X.push(K),n++,t++,K}return X[t++]}function Je(){if(r===o){let K=new Ms;return D.push(K),o++,r++,K}return D[r++]}function ft(){if(l===c){let K=new Ba;return V.push(K),c++,l++,K}return V[l++]}function pt(){if(u===d){let K=new za;return Y.push(K),d++,u++,K}return Y[u++]}function ot(){if(g===b){let K=new ka;return H.push(K),b++,g++,K}return H[g++]}function Ut(K,de){return K.renderOrder!==de.renderOrder?K.renderOrder-de.renderOrder:K.z!==de.z?de.z-K.z:K.id!==de.id?K.id-de.id:0}function Lt(K){m[0]=K[0],m[1]=K[1],m[2]=K[2];let de=3,xe=0;for(let Se=0;Se<ee.length;Se++){let _e=ee[Se];if(xe=0,de===0)break;for(let P=0;P<de;P++){let ue=m[P],ke=m[(P+1)%de],Ue=_e.sign*ue.z+ue.w,ye=_e.sign*ke.z+ke.w,Xe=Ue>=0,Te=ye>=0;if(Xe&&Te)v[xe++]=ue;else if(Xe&&!Te){v[xe++]=ue;let Ge=Ue/(Ue-ye),T=ce[xe];T||(T=new Ct,ce[xe]=T),T.lerpVectors(ue,ke,Ge),v[xe++]=T}else if(!Xe&&Te){let Ge=Ue/(Ue-ye),T=ce[xe];T||(T=new Ct,ce[xe]=T),T.lerpVectors(ue,ke,Ge),v[xe++]=T}}let $e=m;m=v,v=$e,de=xe}return de}function Wt(K,de){let xe=0,Se=1,_e=K.z+K.w,$e=de.z+de.w,P=-K.z+K.w,ue=-de.z+de.w;return _e>=0&&$e>=0&&P>=0&&ue>=0?!0:_e<0&&$e<0||P<0&&ue<0?!1:(_e<0?xe=Math.max(xe,_e/(_e-$e)):$e<0&&(Se=Math.min(Se,_e/(_e-$e))),P<0?xe=Math.max(xe,P/(P-ue)):ue<0&&(Se=Math.min(Se,P/(P-ue))),Se<xe?!1:(K.lerp(de,xe),de.lerp(K,1-Se),!0))}}};var Ch=class{constructor(){let e,t,n,s,r,o,a,l,c,h,u,d=0,f=0,g=0,b=null,p=1,m,v,C=this,M=new vo,R=new vo,E=new nt,y=new nt,A=new nt,k=new nt,U=new nt,L=new nt,G=new F,X=new F,D=new F,V=new F,Y=new at,H=new bt,ce=new bt,q=[],j=[],ie=[],pe=new Eh,he=document.createElementNS("http://www.w3.org/2000/svg","svg");this.domElement=he,this.autoClear=!0,this.sortObjects=!0,this.sortElements=!0,this.overdraw=.5,this.outputColorSpace=Vn,this.info={render:{vertices:0,faces:0}},this.setQuality=function(K){switch(K){case"high":p=1;break;case"low":p=0;break}},this.setClearColor=function(K){L.set(K)},this.setPixelRatio=function(){},this.setSize=function(K,de){s=K,r=de,o=s/2,a=r/2,he.setAttribute("viewBox",-o+" "+-a+" "+s+" "+r),he.setAttribute("width",s),he.setAttribute("height",r),M.min.set(-o,-a),M.max.set(o,a)},this.getSize=function(){return{width:s,height:r}},this.setPrecision=function(K){b=K};function ee(){for(d=0;he.childNodes.length>0;)he.removeChild(he.childNodes[0])}function ge(K){return b!==null?K.toFixed(b):K}function Me(K,de){let xe=K.data.renderOrder!==void 0?K.data.renderOrder:0,Se=de.data.renderOrder!==void 0?de.data.renderOrder:0;if(xe!==Se)return xe-Se;{let _e=K.data.z!==void 0?K.data.z:0;return(de.data.z!==void 0?de.data.z:0)-_e}}this.clear=function(){ee(),he.style.backgroundColor=L.getStyle(C.outputColorSpace)},this.render=function(K,de){if(!(de instanceof cr)){console.error("THREE.SVGRenderer.render: camera is not an instance of Camera.");return}let xe=K.background;xe&&xe.isColor?(ee(),he.style.backgroundColor=xe.getStyle(C.outputColorSpace)):this.autoClear===!0&&this.clear(),C.info.render.vertices=0,C.info.render.faces=0,H.copy(de.matrixWorldInverse),ce.multiplyMatrices(de.projectionMatrix,H),e=pe.projectScene(K,de,this.sortObjects,this.sortElements),t=e.elements,n=e.lights,Y.getNormalMatrix(de.matrixWorldInverse),Le(n),g=0;for(let Se=0,_e=t.length;Se<_e;Se++){let $e=t[Se],P=$e.material;P===void 0||P.opacity===0||Wt(g++,"element",$e,P)}f=0,K.traverseVisible(function(Se){if(Se.isSVGObject){if(G.setFromMatrixPosition(Se.matrixWorld),G.applyMatrix4(ce),G.z<-1||G.z>1)return;let _e=G.x*o,$e=-G.y*a,P=Lt(f++);P.node=Se.node,P.x=_e,P.y=$e,P.z=G.z,P.renderOrder=Se.renderOrder,Wt(g++,"svgObject",P,null)}}),ie.length=g,this.sortElements&&f>0&&ie.sort(Me),m="",v="";for(let Se=0;Se<g;Se++){let _e=ie[Se];if(_e.type==="svgObject"){ot();let $e=_e.data,P=$e.node;P.setAttribute("transform","translate("+$e.x+","+$e.y+")"),he.appendChild(P)}else{let $e=_e.data,P=_e.material;R.makeEmpty(),$e instanceof ka?(l=$e,l.x*=o,l.y*=-a,je(l,$e,P)):$e instanceof za?(l=$e.v1,c=$e.v2,l.positionScreen.x*=o,l.positionScreen.y*=-a,c.positionScreen.x*=o,c.positionScreen.y*=-a,R.setFromPoints([l.positionScreen,c.positionScreen]),M.intersectsBox(R)===!0&&ut(l,c,P)):$e instanceof Ba&&(l=$e.v1,c=$e.v2,h=$e.v3,l.positionScreen.x*=o,l.positionScreen.y*=-a,c.positionScreen.x*=o,c.positionScreen.y*=-a,h.positionScreen.x*=o,h.positionScreen.y*=-a,this.overdraw>0&&(ft(l.positionScreen,c.positionScreen,this.overdraw),ft(c.positionScreen,h.positionScreen,this.overdraw),ft(h.positionScreen,l.positionScreen,this.overdraw)),R.setFromPoints([l.positionScreen,c.positionScreen,h.positionScreen]),M.intersectsBox(R)===!0&&Je(l,c,h,$e,P))}}ot()};function Le(K){A.setRGB(0,0,0),k.setRGB(0,0,0),U.setRGB(0,0,0);for(let de=0,xe=K.length;de<xe;de++){let Se=K[de],_e=Se.color;Se.isAmbientLight?(A.r+=_e.r,A.g+=_e.g,A.b+=_e.b):Se.isDirectionalLight?(k.r+=_e.r,k.g+=_e.g,k.b+=_e.b):Se.isPointLight&&(U.r+=_e.r,U.g+=_e.g,U.b+=_e.b)}}function Ee(K,de,xe,Se){for(let _e=0,$e=K.length;_e<$e;_e++){let P=K[_e],ue=P.color;if(P.isDirectionalLight){let ke=G.setFromMatrixPosition(P.matrixWorld).sub(X.setFromMatrixPosition(P.target.matrixWorld)).normalize(),Ue=xe.dot(ke);if(Ue<=0)continue;Ue*=P.intensity,Se.r+=ue.r*Ue,Se.g+=ue.g*Ue,Se.b+=ue.b*Ue}else if(P.isPointLight){let ke=G.setFromMatrixPosition(P.matrixWorld),Ue=xe.dot(G.subVectors(ke,de).normalize());if(Ue<=0||(Ue*=P.distance==0?1:1-Math.min(de.distanceTo(ke)/P.distance,1),Ue==0))continue;Ue*=P.intensity,Se.r+=ue.r*Ue,Se.g+=ue.g*Ue,Se.b+=ue.b*Ue}}}function je(K,de,xe){let Se=de.scale.x*o,_e=de.scale.y*a;xe.isPointsMaterial&&(Se*=xe.size,_e*=xe.size);let $e="M"+ge(K.x-Se*.5)+","+ge(K.y-_e*.5)+"h"+ge(Se)+"v"+ge(_e)+"h"+ge(-Se)+"z",P="";(xe.isSpriteMaterial||xe.isPointsMaterial)&&(P="fill:"+xe.color.getStyle(C.outputColorSpace)+";fill-opacity:"+xe.opacity),pt(P,$e)}function ut(K,de,xe){let Se="M"+ge(K.positionScreen.x)+","+ge(K.positionScreen.y)+"L"+ge(de.positionScreen.x)+","+ge(de.positionScreen.y);if(xe.isLineBasicMaterial){let _e="fill:none;stroke:"+xe.color.getStyle(C.outputColorSpace)+";stroke-opacity:"+xe.opacity+";stroke-width:"+xe.linewidth+";stroke-linecap:"+xe.linecap;xe.isLineDashedMaterial&&(_e=_e+";stroke-dasharray:"+xe.dashSize+","+xe.gapSize),pt(_e,Se)}}function Je(K,de,xe,Se,_e){C.info.render.vertices+=3,C.info.render.faces++;let $e="M"+ge(K.positionScreen.x)+","+ge(K.positionScreen.y)+"L"+ge(de.positionScreen.x)+","+ge(de.positionScreen.y)+"L"+ge(xe.positionScreen.x)+","+ge(xe.positionScreen.y)+"z",P="";_e.isMeshBasicMaterial?(E.copy(_e.color),_e.vertexColors&&E.multiply(Se.color)):_e.isMeshLambertMaterial||_e.isMeshPhongMaterial||_e.isMeshStandardMaterial?(y.copy(_e.color),_e.vertexColors&&y.multiply(Se.color),E.copy(A),D.copy(K.positionWorld).add(de.positionWorld).add(xe.positionWorld).divideScalar(3),Ee(n,D,Se.normalModel,E),E.multiply(y).add(_e.emissive)):_e.isMeshNormalMaterial&&(V.copy(Se.normalModel).applyMatrix3(Y).normalize(),E.setRGB(V.x,V.y,V.z).multiplyScalar(.5).addScalar(.5)),_e.wireframe?P="fill:none;stroke:"+E.getStyle(C.outputColorSpace)+";stroke-opacity:"+_e.opacity+";stroke-width:"+_e.wireframeLinewidth+";stroke-linecap:"+_e.wireframeLinecap+";stroke-linejoin:"+_e.wireframeLinejoin:P="fill:"+E.getStyle(C.outputColorSpace)+";fill-opacity:"+_e.opacity,pt(P,$e)}function ft(K,de,xe){let Se=de.x-K.x,_e=de.y-K.y,$e=Se*Se+_e*_e;if($e===0)return;let P=xe/Math.sqrt($e);Se*=P,_e*=P,de.x+=Se,de.y+=_e,K.x-=Se,K.y-=_e}function pt(K,de){v===K?m+=de:(ot(),v=K,m=de)}function ot(){m&&(u=Ut(d++),u.setAttribute("d",m),u.setAttribute("style",v),he.appendChild(u)),m="",v=""}function Ut(K){let de=q[K];return de===void 0&&(de=document.createElementNS("http://www.w3.org/2000/svg","path"),p==0&&de.setAttribute("shape-rendering","crispEdges"),q[K]=de),de}function Lt(K){let de=j[K];return de===void 0&&(de={node:null,x:0,y:0,z:0,renderOrder:0},j[K]=de),de}function Wt(K,de,xe,Se){let _e=ie[K];return _e===void 0?(_e={type:de,data:xe,material:Se},ie[K]=_e,_e):(_e.type=de,_e.data=xe,_e.material=Se,_e)}}};function F0(i,e,t,n){let s=[],r=[];i.traverseVisible(l=>{l instanceof Ci&&r.push(l),((l instanceof ps||l instanceof go)&&(l.geometry.getAttribute("position")?.count??0)===0||l instanceof Ci||l instanceof an&&l.geometry.getAttribute("position")===void 0)&&s.push(l)});for(let l of s)l.visible=!1;let o=new Ch;o.setSize(t,n),o.setClearColor(i.background instanceof nt?i.background:new nt("white"),1),o.setPrecision(2),o.render(i,e);for(let l of s)l.visible=!0;let a=o.domElement;a.setAttribute("xmlns","http://www.w3.org/2000/svg");for(let l of r){let c=l.getWorldPosition(new F).project(e),h=document.createElementNS("http://www.w3.org/2000/svg","text");h.textContent=`${l.userData.words}`;let u={x:c.x*t/2,y:-c.y*n/2,"text-anchor":"middle","font-family":"sans-serif","font-size":12,fill:"#64748b"};for(let[d,f]of Object.entries(u))h.setAttribute(d,`${f}`);a.append(h)}return new XMLSerializer().serializeToString(a)}var VT=250,WT=2e3,XT=4,B0=2,YT=.75;function qT(i){let e=i.getExtension("WEBGL_debug_renderer_info"),t=i.getParameter(e?.UNMASKED_RENDERER_WEBGL??i.RENDERER);return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}var Rh=class{constructor(e){this.redraw=e;let t={alpha:!1,depth:!0,stencil:!1,preserveDrawingBuffer:!0},n=document.createElement("canvas"),s=n.getContext("webgl2",{...t,antialias:!1});s!==null&&qT(s)?(this.software=!0,this.renderer=new Da({canvas:n,context:s,...t})):(this.software=!1,s?.getExtension("WEBGL_lose_context")?.loseContext(),this.renderer=new Da({...t,antialias:!0})),this.canvas=this.renderer.domElement,this.fine=!this.software,this.ratio()}redraw;canvas;renderer;software;fine=!0;film=!1;rest=0;before=0;veil=new an(new lr(2,2),new mo({transparent:!0,opacity:YT,depthTest:!1}));size(e,t){this.renderer.setSize(e,t)}draw(e,t){this.software&&this.soften(),this.renderer.render(e,t)}pair(e,t,n,s){this.software&&this.soften();let{renderer:r}=this,{background:o}=e,{x:a,y:l}=r.getSize(new qe);r.autoClear=!1,r.setScissorTest(n),s.forEach((c,h)=>{c(),n?(r.setViewport(h*a/2,0,a/2,l),r.setScissor(h*a/2,0,a/2,l)):h===1&&(this.veil.material.color=o,r.render(new or().add(this.veil),new Ri(-1,1,1,-1,-1,1)),r.clearDepth(),e.background=null),r.render(e,t)}),e.background=o,r.setScissorTest(!1),r.setViewport(0,0,a,l),r.autoClear=!0}filming(e){clearTimeout(this.rest),this.rest=e?-1:0,this.film=e}soften(){let e=this.rest<0;this.fine!==e&&(this.fine=e,this.ratio()),clearTimeout(this.rest);let t=performance.now(),n=Math.min(Math.max(XT*(t-this.before),VT),WT);this.before=t,this.rest=this.film?-1:e?0:setTimeout(()=>{this.rest=-1,this.redraw()},n)}ratio(){let e=Math.min(window.devicePixelRatio,B0);this.renderer.setPixelRatio(this.software?this.fine?B0:Math.min(e,1):e)}};var $T=200,z0=new Set(["trace","ground","rail","track","frame","slider","dial","text"]),k0=new Set(["box","cylinder","cone","disc","sphere","mass","body","circle","mesh"]),ZT=new Set(["rod","spring","damper","rope"]),JT=19,G0=13,KT=.05,jT=20,QT=4,Lh=class{constructor(e,t,n,s,r){this.head=e;this.place=r;this.motion=t,this.screen=new Rh(()=>this.render()),this.canvas=this.screen.canvas,this.canvas.setAttribute("role","img"),this.canvas.setAttribute("aria-label",`The machine ${e.name}, moving`),r.append(this.canvas),this.places=nA(e,t),this.box=Ih(this.places,t);let{length:o,scales:a,coil:l}=e.stage,c=new F(...e.stage.center);this.sizes={length:o,scales:a,coil:l,center:c,planar:e.planar,first:e.scene.first,forms:s,meshes:n},this.camera=e.planar?new Ri:new Xn(35,1,o/100,o*100),this.camera.up.set(...e.stage.axes[1]),this.controls=new Th(this.camera,this.canvas),this.controls.enableRotate=!e.planar,this.controls.addEventListener("change",()=>this.render()),this.controls.addEventListener("start",()=>{this.moved=!0,this.followed=null}),this.scene.add(new xa(16777215,.7),new ga(16777215,9741240,1.2));let h=new _a(16777215,2);h.position.set(.6,1,1.2),this.camera.add(h),this.scene.add(this.camera,this.ghosts),this.furnish(),this.surround(),this.grid=this.ground(o),this.scene.add(this.grid);let{arrows:u}=this;e.planar&&(u.position.z=2*o),this.scene.add(u),this.overlay=e.vectors?new xh(e.vectors,this.sizes,u):null,this.theme(),this.aim(),new ResizeObserver(()=>{(r.clientWidth!==this.canvas.clientWidth||r.clientHeight!==this.canvas.clientHeight)&&this.resize()}).observe(r)}head;place;canvas;screen;scene=new or;camera;controls;drawn=[];box;sizes;grid;ghosts=new Un;arrows=new Un;shown={forces:!0,frames:!1};overlay;moved=!1;now=null;other=null;onlyGauges=!1;motion;numbers=new Float64Array(0);places;followed=null;furnish(){let e=this.head.scene.shapes.filter(Ph),t=this.box.clone();for(let n of this.head.scene.shapes){let s=Ph(n)?O0(n,this.sizes,t,this.facing(),e.indexOf(n),e.length):_h(n,this.sizes);s.object.traverse(r=>r.userData.shape=n),this.drawn.push(s),this.scene.add(s.object)}this.onlyGauges=e.length>0&&this.head.scene.shapes.every(n=>Ph(n)||z0.has(n.kind)),this.show()}enclose(e){let t=this.drawn.filter(({shape:s})=>k0.has(s.kind)),n=new Float64Array(e.width);for(let s=0;s<G0&&e.count>0;++s){let r=Math.round((e.count-1)*s/(G0-1));e.state(e.at(r,0),n);for(let o of t)o.update({numbers:n,first:this.head.scene.first}),o.object.updateMatrixWorld(!0),o.object.visible&&this.box.expandByObject(o.object)}}follow(e){if(this.motion=e,this.moved||this.onlyGauges||this.followed!==null)return;let t=this.box.clone().expandByScalar(KT*this.sizes.length),n=Ih(this.places,e);t.containsBox(n)||n.union(this.box).getSize(new F).length()>jT*this.sizes.length||(this.box.union(n),this.enclose(e),this.aim())}facing(){let[e,t,n]=this.head.stage.axes.map(s=>new F(...s));return new bt().makeBasis(e,t,n)}show(){for(let{object:e,shape:t}of this.drawn)t.kind==="frame"&&(e.visible=this.shown.frames),(t.kind==="force"||t.kind==="torque")&&(e.visible=this.shown.forces)}ground(e){let t=10**Math.floor(Math.log10(e/2)),n=2*Math.ceil(1.5*e/t),s=new va(n*t,n),r=this.box.getCenter(new F);this.head.planar?s.rotation.x=Math.PI/2:s.quaternion.setFromUnitVectors(new F(0,1,0),new F(...this.head.stage.axes[1]));let o=new F(...this.head.stage.axes[1]);if(this.head.planar)s.position.set(H0(r.x,t),H0(r.y,t),-.2*e);else{let a=Math.min(o.dot(this.box.min),o.dot(this.box.max));s.position.copy(r).addScaledVector(o,a-o.dot(r)-.02*e)}return s}lookAt(){this.moved=!1;let e=this.followed===null?this.machineAt(this.numbers):null;this.followed=e!==null&&this.drivesAway(e)?e.getCenter(new F):null,e!==null&&this.followed!==null?this.box.copy(e.expandByScalar(.2*e.getSize(new F).length())):this.surround(),this.aim()}machineAt(e){return V0(new Jn,this.places,t=>e[t])}drivesAway(e){let t=e.getSize(new F).length();return t>0&&Ih(this.places,this.motion).getSize(new F).length()>QT*t}go(){if(this.followed===null)return;let e=this.machineAt(this.numbers).getCenter(new F),t=e.clone().sub(this.followed);this.followed=e,this.box.translate(t),this.camera.position.add(t),this.controls.target.add(t),this.controls.update()}surround(){this.onlyGauges?this.box.makeEmpty():(this.box.copy(Ih(this.places,this.motion)),this.enclose(this.motion));for(let{object:e,shape:t}of this.drawn)Ph(t)&&this.box.expandByObject(e)}aim(){let e=this.box.getSize(new F).length()/Math.SQRT2;this.grid.scale.setScalar(Math.max(Fr(.8*e/this.sizes.length),1)),this.controls.target.copy(this.box.getCenter(new F)),this.resize(),this.controls.update()}fit(e){let t=this.box.getCenter(new F),{length:n}=this.sizes;if(this.camera instanceof Ri){let h=this.box.getSize(new F),u=.12*Math.max(h.x,h.y,.2*n),d=Math.max(h.y/2+u,(h.x/2+u)/e);if(Object.assign(this.camera,{top:d,bottom:-d,right:d*e,left:-d*e}),this.moved)return;Object.assign(this.camera,{near:.1*n,far:30*n,zoom:1}),this.camera.position.copy(t).add(new F(0,0,10*n));return}if(this.camera.aspect=e,this.moved)return;let s=this.facing(),r=new F(0,.38,.92).transformDirection(s),o=new F().setFromMatrixColumn(s,0),a=new F().crossVectors(r,o),l=Math.tan(this.camera.fov*Math.PI/360)/1.12,c=0;for(let h=0;h<8;++h){let u=new F(...[0,1,2].map(f=>(h>>f&1?this.box.max:this.box.min).getComponent(f)));u.sub(t);let d=Math.max(Math.abs(u.dot(o))/e,Math.abs(u.dot(a)));c=Math.max(c,u.dot(r)+d/l)}this.camera.position.copy(t).addScaledVector(r,Math.max(c,.5*n))}resize(){let{clientWidth:e,clientHeight:t}=this.place;e===0||t===0||(this.screen.size(e,t),this.fit((this.other?.beside?.5:1)*(e/t)),this.camera.updateProjectionMatrix(),this.controls.update(),this.legible(t),this.render())}legible(e){let{camera:t}=this,n=t.position.distanceTo(this.box.getCenter(new F)),s=t instanceof Ri?t.top-t.bottom:2*n*Math.tan(t.fov*Math.PI/360),r=JT*s/e;this.scene.traverse(o=>{if(!(o instanceof Ci))return;let a=o.userData.height??=o.scale.y;o.scale.multiplyScalar(Math.max(a,r)/o.scale.y)})}theme(){let e=getComputedStyle(document.documentElement);this.scene.background=new nt(e.getPropertyValue("--stage").trim());let t=new nt(e.getPropertyValue("--grid").trim());for(let n of[this.grid.material].flat())n.vertexColors=!1,n.color=t,n.needsUpdate=!0;this.render()}pose(e,t,n){this.now={motion:e,numbers:t,t:n},this.numbers=t,this.go(),this.overlay?.pose(n),this.set(e,t,n),this.render()}set(e,t,n){let s={numbers:t,first:this.head.scene.first},r=e.rowAt(n);for(let o of this.drawn)o.follow?.(e,r),o.update(s),o.object.updateMatrixWorld(!0)}compare(e,t){this.other=e===null?null:{motion:e,numbers:new Float64Array(e.width),beside:t},this.resize()}postures(e,t){this.ghosts.clear();let n=new Float64Array(e.width);for(let s of t){e.state(s,n);for(let r of this.drawn){if(z0.has(r.shape.kind)||(r.update({numbers:n,first:this.head.scene.first}),!r.object.visible))continue;let o=r.object.clone();o.traverse(a=>{if(!(a instanceof an))return;let l=a.material.clone();Object.assign(l,{transparent:!0,opacity:.22,depthWrite:!1}),a.material=l,a.userData.bent&&(a.geometry=a.geometry.clone())}),this.ghosts.add(o)}}this.ghosts.updateMatrixWorld(!0)}sketch(){return F0(this.scene,this.camera,this.place.clientWidth,this.place.clientHeight)}render(){let{now:e,other:t}=this;if(e===null)return;if(t===null){this.screen.draw(this.scene,this.camera);return}let n=r=>{this.arrows.visible=this.ghosts.visible=!r},s=Math.min(e.t,t.motion.last);this.screen.pair(this.scene,this.camera,t.beside,[()=>{n(!0),this.set(t.motion,t.motion.state(s,t.numbers),s)},()=>{n(!1),this.set(e.motion,e.numbers,e.t)}])}filming(e){this.screen.filming(e)}ray(e,t){let n=this.canvas.getBoundingClientRect(),s=(e-n.left)/n.width,r=new qe((this.other?.beside?2*s%1:s)*2-1,1-(t-n.top)/n.height*2),o=new ya;return o.setFromCamera(r,this.camera),o}held(e,t){let n=this.hitAt(e,t),s=n?.object.userData.shape;if(n===void 0||s===void 0||this.now===null)return null;if(s.kind==="dial")return{shape:s,parts:[],point:this.drawn.find(l=>l.shape===s)?.object.position??n.point};let r=n.object.userData.part;if(r===void 0||r.still||!("at"in r.numbers)||!(k0.has(s.kind)||ZT.has(s.kind)))return null;let o={numbers:this.now.numbers,first:this.head.scene.first},a=eA(r.numbers,n.point,o);return{shape:s,parts:a,point:new F(...gm(o.numbers,a))}}facingPlace(e,t,n){let[s,r,o]=[0,1,2].map(l=>new F().setFromMatrixColumn(this.camera.matrixWorld,l)),a=new Wn().setFromNormalAndCoplanarPoint(o,n);return{place:this.ray(e,t).ray.intersectPlane(a,new F)??n,across:[s,r]}}get length(){return this.sizes.length}hitAt(e,t){let n=(this.overlay?.drawn??[]).filter(r=>r.object.visible),s=[...this.drawn.filter(({object:r})=>r.visible),...n].map(r=>r.object);return this.ray(e,t).intersectObjects(s).find(r=>r.object.visible)}shapeAt(e,t){return this.hitAt(e,t)?.object.userData.shape??null}value(e,t){if(this.overlay?.drawn.some(s=>s.shape===e))return this.overlay.value(e);if(e.kind!=="force"&&e.kind!=="torque")return"";let n=Rn(e.numbers,"vector",{numbers:t,first:this.head.scene.first}).length();return`${Fa(n)} ${vs(e)}`}highlight(e){for(let t of[...this.drawn,...this.overlay?.drawn??[]])t.object.traverse(n=>{n instanceof an&&n.material instanceof gs&&n.material.emissive.setHex(e.includes(t.shape)?8016384:0)});this.render()}};function eA(i,e,t){let n=l=>t.first+i[l],s=Rn(i,"at",t),r=e.clone().sub(s),o=l=>r.dot(l)/Math.max(l.lengthSq(),1e-300);if("to"in i){let l=o(Rn(i,"to",t).sub(s));return[[n("at"),1-l],[n("to"),l]]}let a=[[n("at"),1]];for(let l of["x","z"])l in i&&a.push([n(l),o(Rn(i,l,t))]);return"x"in i&&"z"in i&&a.push([n("z"),o(Rn(i,"z",t).cross(Rn(i,"x",t))),n("x")]),a}function Ph(i){return i.kind==="slider"||i.kind==="dial"}function H0(i,e){return Math.round(i/e)*e}function tA(i,e,t){if(t.count===0)return 0;let s=e.parts.flatMap(({sizes:r})=>r??[]).filter(([,r,o])=>r>=0&&!o).map(([r,o])=>Math.abs(r*t.at(0,i.scene.first+o)));return Math.max(0,...s.filter(Number.isFinite))}function nA(i,e){return i.scene.shapes.filter(({kind:t})=>t!=="frame").flatMap(t=>{let n=tA(i,t,e),r=t.parts.filter(({still:o})=>!o).flatMap(({numbers:o})=>["at","to"].flatMap(a=>o[a]??[]));return[...new Set(r)].map(o=>({column:i.scene.first+o,radius:n}))})}function V0(i,e,t){let n=new F;for(let{column:s,radius:r}of e)n.set(t(s),t(s+1),t(s+2)),Number.isFinite(n.x+n.y+n.z)&&i.expandByPoint(n.clone().addScalar(r)).expandByPoint(n.clone().addScalar(-r));return i}function Ih(i,e){let t=new Jn,n=Math.max(1,Math.floor(e.count/$T));for(let r=0;r<e.count;r+=n)V0(t,i,o=>e.at(r,o));return t.isEmpty()&&t.set(new F(0,0,0),new F(0,0,0)),t.getSize(new F).length()===0&&t.expandByScalar(.5),t}function W0(i){let e=[...document.querySelectorAll("[role=tab]")],t=n=>{for(let s of e)s.ariaSelected=`${s===n}`,s.tabIndex=s===n?0:-1,document.getElementById(s.getAttribute("aria-controls")??"")?.toggleAttribute("hidden",s!==n);i()};e.forEach((n,s)=>{n.onclick=()=>t(n),n.onkeydown=r=>{let o=r.key==="ArrowRight"?1:r.key==="ArrowLeft"?-1:0;if(o===0)return;r.stopPropagation();let a=e[(s+o+e.length)%e.length];t(a),a.focus()}}),t(e[0])}var Dh=class{terms;pinned=null;constructor(e,t,n,s){this.terms=[...t.querySelectorAll("[data-from]")].map(r=>{let a=(r.getAttribute("data-from")??"").split(" ").filter(l=>l!=="").map(l=>e.sources[Number(l)]).filter(l=>l!==null);return{element:r,spans:a}});for(let{element:r,spans:o}of this.terms)r.addEventListener("pointerenter",()=>{this.mark(null),r.classList.add("marked"),n(o)}),r.addEventListener("pointerleave",()=>{this.mark(null),n([])}),r.addEventListener("click",()=>s(o))}first(e){return this.terms.find(({spans:t})=>t.some(n=>Nh(n,e)))?.element??null}pin(e){this.pinned=e,this.mark(null)}mark(e){let t=[e,this.pinned].filter(n=>n!==null);for(let{element:n,spans:s}of this.terms)n.classList.toggle("marked",s.some(r=>t.some(o=>Nh(r,o))))}};function Nh(i,e){return X0(i.first,e.last)&&X0(e.first,i.last)}function X0(i,e){return i[0]<e[0]||i[0]===e[0]&&i[1]<e[1]}function af(i){return(e,t,n)=>{let s=et("button",{textContent:e,title:t,onclick:n});return i.append(s),s}}function Y0(i,e){let t=et("div",{onclick:()=>n.open=!1}),n=et("details",{className:"menu"},et("summary",{textContent:e}),t);return i.append(n),document.addEventListener("pointerdown",s=>{s.target instanceof Node&&n.contains(s.target)||(n.open=!1)}),t}var q0=601,$0=5,Uh=72,iA=480,sA=500,Z0="Keys: space play and pause, arrows step, Home and End, + and - speed, g ghosts, v velocities, f the whole machine, k keep this motion, p present",rA=["one motion","kept one behind","kept one beside"],lf=class{constructor(e,t,n){this.head=e;this.motions=t;this.stage=n;let[s]=t;this.motion=s,this.events=e.events,this.numbers=new Float64Array(s.width),this.player=new yh(e,Vt("player"),o=>this.pose(o)),this.sliders=new Mh(e,Au(t),Vt("sliders"),()=>this.again()),this.influence=new gl(e,Vt("sliders")),this.curves=new dl(e,s,Vt("curves"),o=>this.player.go(o)),this.source=new Sh(e,Vt("source"),o=>this.follow(o),o=>this.toTerms(o)),this.terms=new Dh(e,Vt("derivation"),o=>this.mark(o),o=>this.toSource(o)),this.cells=this.values();let r=Vt("units");r.onchange=()=>Vt("derivation").classList.toggle("units",r.checked),W0(()=>{this.tell(),this.source.pin([]),this.terms.pin(null)}),this.tools(),this.keys(),this.pointer(),dm(e,n,Vt("stage"),{ready:()=>this.live!==null,begin:()=>this.startHere(),pull:o=>this.again(o),turn:(o,a)=>this.sliders.set(o,a)}),location.hash==="#present"&&this.present(!0),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.stage.theme()),this.say(e.said),this.pose(e.start),this.tell(),window.addEventListener("beforeprint",()=>this.tell()),e.modes!==void 0&&(Vt("sliders-tab").textContent="Modes"),new vh(e,Vt("sliders"),o=>this.choose(o)),t.length>1&&e.modes===void 0&&this.curves.behind(t)}head;motions;stage;motion;numbers;player;sliders;influence;curves;source;terms;cells;live=null;ghosts=!1;kept=null;events;arrows=null;endFilm=null;comparing=et("select");ghostly=null;speedy=null;async begin(){this.live=await tr.begin(this.head,q0,e=>this.arrived(e));for(let e of Vt("sliders").querySelectorAll(":scope > :not(#runs)"))e.toggleAttribute("inert",this.live===null),e.hidden=this.head.live===!1;this.live===null&&this.head.live!==!1&&this.say("This browser shows the recorded motion only: sliders need WebAssembly."),this.live!==null&&this.influence.rest(this.sliders.parameters,this.sliders.inputs),document.documentElement.dataset.ready=this.live===null?"recorded":"live",matchMedia("(prefers-reduced-motion: reduce)").matches||this.player.play()}choose(e){let t=this.head.runs?.[e];t!==void 0&&(this.motion=this.motions[e],this.events=t.events,this.player.over(t.start,t.stop,t.pace),this.player.mark(t.events),this.curves.show(this.motion,t.events),t.parameters!==null&&this.sliders.take(t.parameters),this.say(t.said===""?t.label:`${t.label}: ${t.said}`),this.stage.follow(this.motion),this.haunt(),this.pose(this.player.time),t.parameters!==null&&t.said===""&&this.again())}haunt(){let{last:e}=this.motion,t=this.motion.count>0?this.motion.at(0,0):0,n=Array.from({length:$0},(s,r)=>t+(e-t)*r/($0-1));this.stage.postures(this.motion,this.ghosts?n:[])}pose(e){let t=Math.min(e,this.motion.last);this.motion.state(t,this.numbers),this.stage.pose(this.motion,this.numbers,t),this.legend(),this.curves.point(t),Vt("table-panel").hidden||this.tell()}tell(){this.cells.forEach((e,t)=>e.textContent=nf(this.head.columns[t],this.numbers[t]))}again(e=null){this.influence.rest(this.sliders.parameters,this.sliders.inputs),this.live?.run(this.sliders.parameters,this.sliders.inputs,e),this.arrows?.then(t=>t?.run(this.sliders.parameters,this.sliders.inputs))}startHere(){this.player.pause(),this.head.columns.forEach(({name:e,kind:t},n)=>{t==="coordinate"&&this.sliders.put(`${e}.start`,this.numbers[n])}),this.player.go(-1/0)}compare(e){this.kept=e===0?null:this.kept??this.motion,this.stage.compare(this.kept,e===2),this.curves.behind(this.kept===null?this.head.modes===void 0?this.motions.slice(1):[]:[this.kept]),this.pose(this.player.time)}present(e){document.documentElement.toggleAttribute("data-present",e),e&&location.hash!=="#present"?document.documentElement.requestFullscreen?.().catch(()=>{}):document.fullscreenElement!==null&&document.exitFullscreen()}async point(e,t){let n=this.stage.overlay;if(n!==null){if(t?n.shown.add(e):n.shown.delete(e),t&&this.arrows===null){let s=({motion:r})=>{n.take(r),document.documentElement.dataset.arrows=`${r.count}`,this.pose(this.player.time)};this.arrows=tr.begin(this.head,q0,s,{tape:"vectors"}),await this.arrows===null&&this.say("Arrows need WebAssembly."),this.again()}this.pose(this.player.time)}}mark(e){let t=this.head.scene.shapes.filter(({span:n})=>n!==null&&e.some(s=>Nh(s,n)));this.stage.highlight(t),this.source.mark(e),Vt("pointed").textContent=t.map(n=>n.name).join(", ")}follow(e){this.mark(e===null?[]:[e]),this.terms.mark(e)}toSource(e){Vt("source-tab").click(),this.source.pin(e)}toTerms(e){let t=this.terms.first(e);if(t===null){this.say("No term of the equations comes from this line.");return}Vt("derivation-tab").click(),this.terms.pin(e),t.scrollIntoView({block:"center"})}fit(){this.stage.lookAt(),this.pose(this.player.time)}legend(){let e=(this.stage.overlay?.legend()??[]).join(`
`),t=Vt("legend");t.textContent!==e&&(t.textContent=e)}arrived({motion:e,status:t,time:n,took:s,parameters:r,events:o,blamed:a}){let l=e.count===0;document.documentElement.toggleAttribute("data-failed",l),l?this.player.pause():(this.motion=e,this.events=o.map(([c,h,u])=>{let{kind:d,names:f}=this.head.event_names[h];return{time:c,kind:d,name:f[u]??""}}),this.sliders.take(r),this.curves.show(e,this.events),this.player.mark(this.events),this.stage.follow(e),this.haunt(),this.pose(this.player.time)),document.documentElement.dataset.took=s.toFixed(2),t===0?this.say(`Integrated anew in ${s.toFixed(1)} ms.`):t===ml?this.say(`This motion takes long; it is shown up to ${n.toPrecision(4)} s.`):this.say(`${l?"This start cannot be. ":""}${pl(this.head,t,a)} (t = ${n.toPrecision(5)} s)`)}say(e){Vt("said").textContent=e}values(){let e=Vt("values");return this.head.columns.slice(0,this.head.scene.first).map(t=>{let n=et("td"),s=et("th",{scope:"row",textContent:t.name});return e.append(et("tr",{},s,n,et("td",{textContent:t.display.unit}))),n})}tools(){let e=af(Vt("tools")),t=(n,s)=>{let r=e(n,s,()=>{this.stage.shown[n]=!this.stage.shown[n],r.ariaPressed=`${this.stage.shown[n]}`,this.stage.show(),this.pose(this.player.time)});r.ariaPressed=`${this.stage.shown[n]}`};this.head.scene.shapes.some(({kind:n})=>n==="force"||n==="torque")&&t("forces","Arrows of loads"),this.switches(e),this.head.scene.shapes.some(({kind:n})=>n==="frame")&&t("frames","Axes of frames"),this.ghostly=e("ghosts","Pale postures of several instants (key g)",()=>this.toggleGhosts()),this.ghostly.ariaPressed="false",e("fit","The whole machine (key f)",()=>this.fit()),e("present","The picture alone, in large type (key p)",()=>this.present(!0)),e("keys",Z0,()=>this.say(Z0)),this.comparing.title="Keep this motion (key k), and see it with the next ones",this.comparing.ariaLabel=this.comparing.title,this.comparing.append(...rA.map((n,s)=>new Option(n,`${s}`))),this.comparing.onchange=()=>this.compare(Number(this.comparing.value)),Vt("tools").append(this.comparing),this.saving()}saving(){let e=af(Y0(Vt("tools"),"save"));if(e("PNG","The picture",()=>am(this.stage.canvas,this.head)),e("SVG","The picture as lines and faces",()=>Br(new Blob([this.stage.sketch()],{type:"image/svg+xml"}),`${this.head.name}.svg`)),e("GIF","The motion as a film that plays everywhere",()=>{this.filmed()}),e("CSV","The values",()=>lm(this.motion,this.head)),typeof MediaRecorder>"u")return;let t=e("film","Record what plays",()=>{this.endFilm===null?(this.endFilm=cm(this.stage.canvas,this.head),this.player.play()):(this.endFilm(),this.endFilm=null),t.ariaPressed=`${this.endFilm!==null}`})}switches(e){let t=this.stage.overlay;if(t===null)return;for(let[r,o,a]of R0){if(!t.has(r))continue;let l=e(o,a,()=>{let c=!t.shown.has(r);l.ariaPressed=`${c}`,this.point(r,c),r==="admissible"&&(s.hidden=!c)});l.ariaPressed="false",r==="velocity"&&(this.speedy=l)}let n="The coordinate that moves",s=et("select",{title:n,ariaLabel:n,hidden:!0});s.append(new Option("all coordinates",""),...t.coordinates.map(r=>new Option(r,r))),s.onchange=()=>{t.coordinate=s.value,this.pose(this.player.time)},Vt("tools").append(s)}toggleGhosts(){this.ghosts=!this.ghosts,this.ghostly!==null&&(this.ghostly.ariaPressed=`${this.ghosts}`),this.haunt(),this.pose(this.player.time)}async filmed(){this.player.pause();let{canvas:e}=this.stage,t=Math.min(iA,e.width),n=et("canvas",{width:t,height:Math.round(t*e.height/e.width)}),s=n.getContext("2d",{willReadFrequently:!0});if(s===null)return;Object.assign(s,{imageSmoothingQuality:"high"}),this.stage.filming(!0);let{time:r}=this.player,o=this.motion.at(0,0),a=this.motion.last-o,l=[];for(let h=0;h<Uh;++h)this.pose(o+a*h/(Uh-1)),s.drawImage(e,0,0,n.width,n.height),l.push(s.getImageData(0,0,n.width,n.height)),h%8===0&&(this.say(`Film: ${h+1} of ${Uh} pictures`),await new Promise(u=>setTimeout(u)));let c=Math.min(Math.max(a,3),10);Br(um(l,1e3*c/Uh),`${this.head.name}.gif`),this.say("The film is saved."),this.stage.filming(!1),this.pose(r)}keys(){xm({" ":()=>this.player.toggle(),ArrowRight:()=>this.player.step(.01),ArrowLeft:()=>this.player.step(-.01),"+":()=>this.player.faster(1),"-":()=>this.player.faster(-1),g:()=>this.toggleGhosts(),v:()=>this.speedy?.click(),f:()=>this.fit(),k:()=>this.keep(),p:()=>this.present(!document.documentElement.hasAttribute("data-present")),Escape:()=>this.present(!1),Home:()=>this.player.go(-1/0),End:()=>this.player.go(1/0)}),document.addEventListener("fullscreenchange",()=>{document.fullscreenElement===null&&location.hash!=="#present"&&this.present(!1)})}keep(){this.kept=this.motion,this.comparing.value=`${Math.max(Number(this.comparing.value),1)}`,this.compare(Number(this.comparing.value))}pointer(){let e=null;this.stage.canvas.addEventListener("pointermove",t=>{if(t.buttons!==0)return;let n=this.stage.shapeAt(t.clientX,t.clientY);if(n===e)return;e=n,this.stage.highlight(n===null?[]:[n]),this.source.mark(n?.span?[n.span]:[]),this.terms.mark(n?.span??null);let s=n===null?"":this.stage.value(n,this.numbers);Vt("pointed").textContent=[n?.name??"",s].filter(r=>r!=="").join(": ")})}};function oA(){return new Promise(i=>{requestAnimationFrame(()=>setTimeout(i)),setTimeout(i,sA)})}async function aA(){let i=fm(),e=await Promise.all(i.meshes.map(qd)),t=mm(i,await zr("motion")),n=Object.entries(i.stage.forms).map(async([o,a])=>[o,await qd(a)]),s=new Lh(i,Au(t),e,new Map(await Promise.all(n)),Vt("stage")),[r]=t;s.pose(r,r.state(i.start,new Float64Array(r.width)),i.start),await oA(),pm(),await new lf(i,t,s).begin()}aA().catch(i=>{Vt("said").textContent=`The page cannot be shown: ${String(i)}`});})();
