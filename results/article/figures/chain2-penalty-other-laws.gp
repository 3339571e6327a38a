# gnuplot chain2-penalty-other-laws.gp makes chain2-penalty-other-laws.svg and chain2-penalty-other-laws.pdf of chain2-penalty-other-laws.dat
data = 'chain2-penalty-other-laws.dat'
svg = "svg size 643,378 font 'sans-serif,9' fontscale 1.333 background '#ffffff' dashlength 0.7 rounded"
pdf = "pdfcairo size 17.0cm,10.0cm font 'sans,9' dashlength 0.7 rounded"
do for [format in 'svg pdf'] {
reset
eval 'set terminal '.(format eq 'svg' ? svg : pdf)
set output 'chain2-penalty-other-laws.'.format
set logscale xy
set format '10^{%T}'
set xlabel 'time, set-up and solve [s]'
set ylabel 'error of x and force, own law [-]'
set xrange [7.97e-05:8.23e-02]
set yrange [6.75e-11:3.53e+00]
set grid back lc rgb '#cccccc' lw 0.5
set border 3
set tics nomirror
unset key
set rmargin at screen 0.500
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e4x] (k = 10000 N/m)' at graph 1.06,0.8766 left font ',9' textcolor rgb '#0072B2' noenhanced
set arrow from 2.744585e-02,1.675901e-01 to graph 1.05,0.8766 nohead lc rgb '#0072B2' lw 0.5 back
set label 'penalty-hbm[plain=true,solver=pivoting,penalty=1e5x] (k = 100000 N/m)' at graph 1.06,0.9386 left font ',9' textcolor rgb '#D55E00' noenhanced
set arrow from 1.765798e-02,5.223207e-01 to graph 1.05,0.9386 nohead lc rgb '#D55E00' lw 0.5 back
set label '10 error bars' at graph 0.99, first 2.023995e-10 right offset 0,-0.6 font ',7' textcolor rgb '#888888'
set label '10' at 2.391140e-04,7.369704e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '40' at 3.141065e-03,4.697493e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '160' at 2.744585e-02,1.675901e-01 offset 0.4,0.5 font ',7' textcolor rgb '#0072B2' noenhanced
set label '10' at 2.910110e-04,1.175711e+00 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '40' at 2.409591e-03,7.947450e-01 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
set label '160' at 1.765798e-02,5.223207e-01 offset 0.4,0.5 font ',7' textcolor rgb '#D55E00' noenhanced
plot data index 0 with lines lc rgb '#0072B2' dt '-' lw 1.6 notitle, \
  data index 1 with points lc rgb '#0072B2' pt 11 ps 1.1 notitle, \
  data index 2 with lines lc rgb '#D55E00' dt '.' lw 1.6 notitle, \
  data index 3 with points lc rgb '#D55E00' pt 13 ps 1.1 notitle, \
  2.023995e-10 with lines lc rgb '#888888' dt 3 lw 1 notitle
unset output
}
